package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Path;
import org.robonewbie.nao.text.PrintableText;

/** Thrown when a file cannot be read. The message is intended for the user: it gives the file and the reason, and says what to do. */
public final class UnreadableFileException extends IOException {

    private static final long serialVersionUID = 1L;

    /**
     * Creates an exception about a line of a file.
     *
     * @param file the file
     * @param line the one-based line number
     * @param problem the problem and what to do, in complete sentences
     * @return the exception
     */
    public static UnreadableFileException atLine(Path file, int line, String problem) {
        return new UnreadableFileException(PrintableText.of(file.toString()) + ", line " + line + ": " + problem);
    }

    /** Creates an exception from a problem phrased to follow the file's name, such as {@code does not exist.} */
    UnreadableFileException(Path file, String problem) {
        super(sentence(file, problem));
    }

    UnreadableFileException(Path file, String problem, IOException cause) {
        super(sentence(file, problem), cause);
    }

    /**
     * Creates an exception with a complete message.
     *
     * @param sentence message with the file, why it cannot be read, and what to do
     */
    public UnreadableFileException(String sentence) {
        super(sentence);
    }

    private static String sentence(Path file, String problem) {
        return "The file " + PrintableText.of(file.toString()) + " " + problem;
    }
}
