package org.robonewbie.nao.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reads files of which nothing is known yet: no device or pipe is opened, which could block for ever, and no more bytes are read
 * than are allowed.
 */
public final class RegularFile {

    private RegularFile() {}

    /**
     * Reads a file.
     *
     * @param file the file, or a symbolic link to one
     * @param maxBytes the largest size that makes sense for it
     * @return all of its bytes
     * @throws UnreadableFileException if there is none, it is no regular file, larger than {@code maxBytes}, or cannot be read
     */
    public static byte[] read(Path file, int maxBytes) throws UnreadableFileException {
        try {
            check(file, maxBytes);
            try (InputStream in = Files.newInputStream(file)) {
                byte[] bytes = in.readNBytes(maxBytes);
                if (in.read() >= 0) {
                    throw tooLarge(file, maxBytes);
                }
                return bytes;
            }
        } catch (UnreadableFileException known) {
            throw known;
        } catch (AccessDeniedException denied) {
            throw new UnreadableFileException(file, "may not be read. Change its permissions, or copy it.", denied);
        } catch (IOException other) {
            throw new UnreadableFileException(file, "cannot be read (" + other.getMessage() + ").", other);
        }
    }

    /**
     * Checks a file without opening it, as {@link #read} does first.
     *
     * @param file the file, or a symbolic link to one
     * @param maxBytes the largest size that makes sense for it
     * @throws UnreadableFileException if {@link #read} would refuse it for what it is
     */
    public static void check(Path file, int maxBytes) throws UnreadableFileException {
        check(file);
        try {
            if (Files.size(file) > maxBytes) {
                throw tooLarge(file, maxBytes);
            }
        } catch (UnreadableFileException known) {
            throw known;
        } catch (IOException other) {
            throw new UnreadableFileException(file, "cannot be read (" + other.getMessage() + ").", other);
        }
    }

    private static UnreadableFileException tooLarge(Path file, int maxBytes) {
        return new UnreadableFileException(
                file, "is larger than " + size(maxBytes) + ", which is more than such a file may have.");
    }

    private static void check(Path file) throws UnreadableFileException {
        if (Files.isDirectory(file)) {
            throw new UnreadableFileException(file, "is a folder. Name a file in it.");
        }
        if (!Files.exists(file)) {
            throw new UnreadableFileException(
                    file,
                    file.isAbsolute()
                            ? "does not exist. Is its name right?"
                            : "does not exist in the folder " + Path.of("").toAbsolutePath() + ". Is its name right?");
        }
        if (!Files.isRegularFile(file)) {
            throw new UnreadableFileException(file, "is no regular file but a device or a pipe, and is not read.");
        }
    }

    private static String size(int bytes) {
        int mebibyte = 1 << 20;
        return bytes >= mebibyte ? bytes / mebibyte + " MB" : bytes + " bytes";
    }
}
