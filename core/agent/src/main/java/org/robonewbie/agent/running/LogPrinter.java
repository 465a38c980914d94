package org.robonewbie.agent.running;

import java.io.PrintStream;
import org.robonewbie.agent.log.RunLog;

/** Prints a robot's log when its run is over, however it ends: normally, by Ctrl-C, or because the program gives up. */
public final class LogPrinter implements AutoCloseable {

    private final RunLog log;
    private final PrintStream out;
    private final Runnable atInterrupt;
    private final Thread hook = new Thread(this::printAtShutdown, "log-printer");

    /**
     * Waits for the end of the run.
     *
     * @param log the robot's log; what does not fit into memory goes to a file
     * @param out where to print
     * @param atInterrupt what else to do if the program is interrupted
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
            // the hook is at work
        }
    }

    private void printAtShutdown() {
        log.print(out);
        atInterrupt.run();
    }
}
