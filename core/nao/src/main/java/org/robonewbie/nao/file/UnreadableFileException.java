package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.Path;
import org.robonewbie.nao.text.PrintableText;

/** Says in a sentence for users why a file cannot be read and what to do about it; the message names the file. */
public final class UnreadableFileException extends IOException {

    private static final long serialVersionUID = 1L;

    /**
     * Creates an exception about a line of a file.
     *
     * @param file the file
     * @param line the number of the line, 1 for the first
     * @param problem what is wrong and what to write, in whole sentences
     * @return the exception
     */
    public static UnreadableFileException atLine(Path file, int line, String problem) {
        return new UnreadableFileException(PrintableText.of(file.toString()) + ", line " + line + ": " + problem);
    }

    /**
     * @param file the file
     * @param problem what follows its name, such as {@code does not exist.}
     */
    UnreadableFileException(Path file, String problem) {
        super(sentence(file, problem));
    }

    /**
     * @param file the file
     * @param problem what follows its name, such as {@code cannot be read.}
     * @param cause what the system says
     */
    UnreadableFileException(Path file, String problem, IOException cause) {
        super(sentence(file, problem), cause);
    }

    /**
     * Creates an exception with a complete message.
     *
     * @param sentence names the file, says why it cannot be read and what to do
     */
    public UnreadableFileException(String sentence) {
        super(sentence);
    }

    private static String sentence(Path file, String problem) {
        return "The file " + PrintableText.of(file.toString()) + " " + problem;
    }
}
