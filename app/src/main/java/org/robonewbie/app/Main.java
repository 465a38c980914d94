package org.robonewbie.app;

import org.robonewbie.app.command.RoboNewbieCommand;

/**
 * Starts RoboNewbie from the command line. The exit code is 0 when all went well, 1 when a command ran and failed, 2 when
 * it was called wrongly.
 */
public final class Main {

    private Main() {}

    /**
     * Runs one command and ends the process.
     *
     * @param arguments the command and its options; none runs the demo
     */
    public static void main(String[] arguments) {
        QuietLogging.install();
        System.exit(RoboNewbieCommand.run(arguments));
    }
}
