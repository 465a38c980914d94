package org.robonewbie.nao.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Reads untrusted files safely: never opens a device or a pipe, which could block forever, and limits the number of
 * bytes read.
 */
public final class RegularFile {

    private RegularFile() {}

    /**
     * Reads a file.
     *
     * @param file the file, or a symbolic link to one
     * @param maxBytes maximum accepted size in bytes
     * @return the contents of the file
     * @throws UnreadableFileException if the file does not exist, is not a regular file, is larger than {@code maxBytes}, or cannot
     *     be read
     */
    public static byte[] read(Path file, int maxBytes) throws UnreadableFileException {
        check(file, maxBytes);
        byte[] bytes;
        try (InputStream in = Files.newInputStream(file)) {
            bytes = in.readNBytes(maxBytes + 1);
        } catch (AccessDeniedException denied) {
            throw new UnreadableFileException(
                    file, "cannot be read: permission denied. Change its permissions, or copy it.", denied);
        } catch (IOException other) {
            throw new UnreadableFileException(file, "cannot be read (" + other.getMessage() + ").", other);
        }
        checkSize(file, bytes.length, maxBytes);
        return bytes;
    }

    /**
     * Checks a file without opening it; {@link #read} makes the same checks first.
     *
     * @param file the file, or a symbolic link to one
     * @param maxBytes maximum accepted size in bytes
     * @throws UnreadableFileException if the file does not exist, is not a regular file, or is larger than {@code maxBytes}
     */
    public static void check(Path file, int maxBytes) throws UnreadableFileException {
        if (Files.isDirectory(file)) {
            throw new UnreadableFileException(file, "is a folder. Name a file in it.");
        }
        if (!Files.exists(file)) {
            throw new UnreadableFileException(
                    file,
                    file.isAbsolute()
                            ? "does not exist. Check the name."
                            : "does not exist in the folder " + Path.of("").toAbsolutePath() + ". Check the name.");
        }
        if (!Files.isRegularFile(file)) {
            throw new UnreadableFileException(file, "is not a regular file but a device or a pipe.");
        }
        checkSize(file, file.toFile().length(), maxBytes);
    }

    private static void checkSize(Path file, long bytes, int maxBytes) throws UnreadableFileException {
        if (bytes > maxBytes) {
            int mebibyte = 1 << 20;
            String limit = maxBytes >= mebibyte ? maxBytes / mebibyte + " MB" : maxBytes + " bytes";
            throw new UnreadableFileException(file, "is larger than " + limit + ", the maximum for such a file.");
        }
    }
}
