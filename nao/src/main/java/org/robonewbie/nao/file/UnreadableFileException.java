package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Path;

/** Says in a sentence for users why a file cannot be read and what to do about it; the message names the file. */
public final class UnreadableFileException extends IOException {

    private static final long serialVersionUID = 1L;

    /**
     * @param file the file
     * @param problem what follows its name, such as {@code does not exist.}
     */
    UnreadableFileException(Path file, String problem) {
        super("The file " + file + " " + problem);
    }

    /**
     * @param file the file
     * @param problem what follows its name, such as {@code cannot be read.}
     * @param cause what the system says
     */
    UnreadableFileException(Path file, String problem, IOException cause) {
        super("The file " + file + " " + problem, cause);
    }
}
