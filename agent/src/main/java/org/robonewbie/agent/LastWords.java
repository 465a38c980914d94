package org.robonewbie.agent;

import java.io.PrintStream;
import org.robonewbie.agent.log.Logger;

/** Prints a robot's log when its run is over, however it ends: regularly, by Ctrl-C, or since the program gives up. */
final class LastWords implements AutoCloseable {

    private final Logger log;
    private final Home home;
    private final PrintStream out;
    private final Thread atShutdown = new Thread(this::speak, "last-words");

    LastWords(Logger log, Home home, PrintStream out) {
        this.log = log;
        this.home = home;
        this.out = out;
        Runtime.getRuntime().addShutdownHook(atShutdown);
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(atShutdown);
            log.print(out);
        } catch (IllegalStateException shuttingDown) {
            // the hook itself is at work
        }
    }

    private void speak() {
        log.print(out);
        home.close();
    }
}
