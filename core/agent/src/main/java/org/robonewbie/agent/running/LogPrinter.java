package org.robonewbie.agent.running;

import java.io.PrintStream;
import org.robonewbie.agent.log.RunLog;

/** Prints a robot's log at the end of its run, even after Ctrl-C or {@code System.exit}. */
public final class LogPrinter implements AutoCloseable {

    private final RunLog log;
    private final PrintStream out;
    private final Runnable atInterrupt;
    private final Thread hook = new Thread(this::printAtShutdown, "log-printer");

    /**
     * Registers the log for printing.
     *
     * @param log the robot's log; lines that do not fit into memory go to a file
     * @param out the output
     * @param atInterrupt called after printing if the program is interrupted
     */
    public LogPrinter(RunLog log, PrintStream out, Runnable atInterrupt) {
        this.log = log;
        this.out = out;
        this.atInterrupt = atInterrupt;
        log.setOverflow(new LogFile());
        Runtime.getRuntime().addShutdownHook(hook);
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
            log.print(out);
        } catch (IllegalStateException shuttingDown) {
            // the shutdown hook prints the log
        }
    }

    private void printAtShutdown() {
        log.print(out);
        atInterrupt.run();
    }
}
