package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import org.robonewbie.nao.text.PrintableText;

/**
 * Thrown when a file cannot be written. The message is intended for the user: it gives the file and the reason, and
 * says what to do.
 */
public final class UnwritableFileException extends IOException {

    private static final long serialVersionUID = 1L;

    private UnwritableFileException(String message, IOException cause) {
        super(message, cause);
    }

    /**
     * Creates an exception whose message explains an error from the operating system.
     *
     * @param file the file
     * @param cause the error
     * @return the exception; {@code cause} itself if it already is one
     */
    public static UnwritableFileException of(Path file, IOException cause) {
        return cause instanceof UnwritableFileException known
                ? known
                : new UnwritableFileException(
                        "The file " + PrintableText.of(file.toString()) + " cannot be written: " + reason(cause),
                        cause);
    }

    static UnwritableFileException inUse(Path file) {
        return new UnwritableFileException(
                "The file " + PrintableText.of(file.toString())
                        + " is being written by another program. Wait until it finishes, or name another file.",
                new IOException("in use"));
    }

    private static String reason(IOException cause) {
        String detail = cause instanceof FileSystemException system && system.getReason() != null
                ? system.getReason()
                : String.valueOf(cause.getMessage());
        String words = detail.toLowerCase(Locale.ROOT);
        if (words.contains("no space left") || words.contains("not enough space") || words.contains("quota")) {
            return "the disk is full (" + detail + "). Free up some space and start again.";
        }
        String problem = cause instanceof AccessDeniedException || words.contains("read-only")
                ? "writing is not permitted there"
                : cause instanceof NoSuchFileException
                        ? "its folder does not exist, or another program has moved it"
                        : detail.isEmpty() ? cause.getClass().getSimpleName() : detail;
        return problem + ". Choose a file in an existing folder that you may write to.";
    }
}
