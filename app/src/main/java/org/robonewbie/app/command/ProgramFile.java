package org.robonewbie.app.command;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.process.JavaCommand;

/** The one file that holds this program. */
public final class ProgramFile {

    private static final String MAIN = "org.robonewbie.app.Main";

    private ProgramFile() {}

    /**
     * Returns the command line of another process of this program.
     *
     * @param arguments command and what follows it
     * @return program and arguments
     */
    public static List<String> command(List<String> arguments) {
        return JavaCommand.of(List.of(), ClassPath.ofThisProgram(), MAIN, arguments);
    }

    /** {@return the jar that this class comes from; empty if it comes from a folder, as in an IDE} */
    public static Optional<Path> ofThisProgram() {
        return Optional.of(ClassPath.ownPlace()).filter(Files::isRegularFile);
    }
}
