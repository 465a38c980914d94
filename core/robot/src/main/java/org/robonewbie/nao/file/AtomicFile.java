package org.robonewbie.nao.file;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/**
 * Atomic writes: a file appears under its final name only when it is complete. Until then, its name has the suffix
 * {@code .part}, so a killed program or a full disk leaves an existing file unchanged.
 *
 * <pre>{@code
 * AtomicFile.write(Path.of("report.json"), report.toJson());
 * }</pre>
 */
public final class AtomicFile {

    /** Suffix of a file that is still being written. */
    public static final String UNFINISHED = ".part";

    private static final int DIGITS = 8;

    private AtomicFile() {}

    /**
     * Writes a text file in UTF-8, replacing an existing one.
     *
     * @param file the file
     * @param text the contents of the file
     * @throws UnwritableFileException if the file cannot be written; no partial file remains
     */
    public static void write(Path file, String text) throws UnwritableFileException {
        write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Writes a file, replacing an existing one. If two programs write the same file at the same time, the one that
     * finishes last wins.
     *
     * @param file the file
     * @param bytes the contents of the file
     * @throws UnwritableFileException if the file cannot be written; no partial file remains
     */
    public static void write(Path file, byte[] bytes) throws UnwritableFileException {
        String unique = UUID.randomUUID().toString().substring(0, DIGITS);
        Path part = file.resolveSibling(
                "." + unique + UNFINISHED); // omits the file's name, which may already have the maximum length
        try {
            try {
                Files.write(part, bytes, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
                move(part, file);
            } finally {
                Files.deleteIfExists(part);
            }
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /**
     * Returns the temporary path of a file that is being written; other programs may read it there.
     *
     * @param file the final path
     * @return the path that the file has until it is complete
     */
    public static Path part(Path file) {
        return file.resolveSibling(file.getFileName() + UNFINISHED);
    }

    /**
     * Opens {@link #part} for writing and locks it against other programs until the stream is closed.
     *
     * @param file the final path
     * @return a stream whose errors are {@link UnwritableFileException}s
     * @throws UnwritableFileException if the file cannot be written, or another program is writing it
     */
    public static OutputStream begin(Path file) throws UnwritableFileException {
        try {
            FileChannel channel = FileChannel.open(part(file), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            if (FolderLock.isTaken(channel)) {
                channel.close();
                throw UnwritableFileException.inUse(file);
            }
            channel.truncate(0);
            return new PartStream(file, Channels.newOutputStream(channel));
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /**
     * Moves a complete {@link #part} to its final path, replacing an existing file.
     *
     * @param file the final path
     * @throws UnwritableFileException if the file cannot be moved
     */
    public static void moveIntoPlace(Path file) throws UnwritableFileException {
        try {
            move(part(file), file);
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    private static void move(Path part, Path file) throws IOException {
        try {
            Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Stream that converts errors to {@link UnwritableFileException}s. */
    private static final class PartStream extends FilterOutputStream {

        private final Path file;

        PartStream(Path file, OutputStream out) {
            super(out);
            this.file = file;
        }

        @Override
        public void write(int single) throws IOException {
            write(new byte[] {(byte) single}, 0, 1);
        }

        @Override
        public void write(byte[] bytes, int offset, int length) throws IOException {
            try {
                out.write(bytes, offset, length);
            } catch (IOException unwritable) {
                throw UnwritableFileException.of(file, unwritable);
            }
        }
    }
}
