package org.robonewbie.app;

import java.io.IOException;
import java.util.Optional;
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
     * @throws IOException if the program's own file cannot be looked at
     */
    public static void main(String[] arguments) throws IOException {
        prepare();
        Optional<StartArchive> archive = StartArchive.wanted();
        if (archive.isPresent()) {
            archive.get().makeAtTheEnd();
        }
        System.exit(RoboNewbieCommand.run(arguments));
    }

    /** What comes before each command. */
    static void prepare() {
        QuietLogging.install();
    }
}
