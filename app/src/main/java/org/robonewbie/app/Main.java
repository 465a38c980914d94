package org.robonewbie.app;

import java.io.File;
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
        Optional.ofNullable(System.getProperty("robonewbie.link")).ifPresent(Main::deleteAtTheEnd);
        Optional<StartArchive> archive = StartArchive.wanted();
        if (archive.isPresent()) {
            archive.get().makeAtTheEnd();
        }
        System.exit(RoboNewbieCommand.run(arguments));
    }

    /** The launcher has made a folder with a jar that refers to this program, whose own place cannot stand in a class path. */
    private static void deleteAtTheEnd(String link) {
        File folder = new File(link);
        folder.deleteOnExit(); // what was named last is deleted first
        new File(folder, "manifest").deleteOnExit();
        new File(folder, "robonewbie.jar").deleteOnExit();
    }

    /** What comes before each command. */
    static void prepare() {
        QuietLogging.install();
    }
}
