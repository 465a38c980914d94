package org.robonewbie.app;

import java.io.File;
import java.io.IOException;
import java.util.Optional;
import org.robonewbie.app.command.RoboNewbieCommand;

/**
 * Entry point of the command line. The exit code is 0 on success, 1 if a command ran and failed, and 2 if it was called incorrectly.
 */
public final class Main {

    private Main() {}

    /**
     * Runs one command and exits.
     *
     * @param arguments the command and its options; runs the demo if empty
     * @throws IOException if the attributes of the program's file cannot be read
     */
    public static void main(String[] arguments) throws IOException {
        prepare();
        Optional.ofNullable(System.getProperty("robonewbie.link")).ifPresent(Main::deleteOnExit);
        Optional<StartArchive> archive = StartArchive.wanted();
        if (archive.isPresent()) {
            archive.get().createOnExit();
        }
        System.exit(RoboNewbieCommand.run(arguments));
    }

    /**
     * Deletes the temporary folder that contains the launcher's link to this program. The launcher creates it if the
     * program's path cannot be used in a class path.
     */
    private static void deleteOnExit(String link) {
        File folder = new File(link);
        folder.deleteOnExit(); // files are deleted in reverse order of registration
        new File(folder, "manifest").deleteOnExit();
        new File(folder, "robonewbie.jar").deleteOnExit();
    }

    static void prepare() {
        QuietLogging.install();
    }
}
