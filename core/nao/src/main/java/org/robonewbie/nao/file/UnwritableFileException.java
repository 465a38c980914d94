package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.text.PrintableText;

/** Says in a sentence for users which file cannot be written, why, and what to do. */
public final class UnwritableFileException extends IOException {

    private static final long serialVersionUID = 1L;

    private UnwritableFileException(String sentence, IOException cause) {
        super(sentence, cause);
    }

    /**
     * Words what the system says.
     *
     * @param file the file
     * @param cause what the system says
     * @return the sentence
     */
    public static UnwritableFileException of(Path file, IOException cause) {
        return cause instanceof UnwritableFileException known
                ? known
                : new UnwritableFileException(
                        "The file " + PrintableText.of(file.toString()) + " cannot be written: " + reason(cause),
                        cause);
    }

    /**
     * Refuses a second writer.
     *
     * @param file the file
     * @return the sentence
     */
    static UnwritableFileException isInUse(Path file) {
        return new UnwritableFileException(
                "The file " + PrintableText.of(file.toString())
                        + " is being written by another program. Wait for its end, or name another file.",
                new IOException("in use"));
    }

    private static String reason(IOException cause) {
        String told = Optional.ofNullable(detail(cause)).orElse("");
        String words = told.toLowerCase(Locale.ROOT);
        if (words.contains("no space left") || words.contains("not enough space") || words.contains("quota")) {
            return "the disk is full (" + told + "). Make room and start again.";
        }
        String problem = cause instanceof AccessDeniedException || words.contains("read-only")
                ? "nothing may be written there"
                : cause instanceof NoSuchFileException
                        ? "its folder does not exist, or another program has moved it"
                        : told.isEmpty() ? cause.getClass().getSimpleName() : told;
        return problem + ". Choose a file in a folder that exists and in which you may write.";
    }

    private static String detail(IOException cause) {
        return cause instanceof FileSystemException system && system.getReason() != null
                ? system.getReason()
                : String.valueOf(cause.getMessage());
    }
}
