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
 * Files that appear under their name as a whole or not at all. While they are written they have a name with the ending {@code .part},
 * so a program that is killed, or finds the disk full, leaves the former file as it was.
 *
 * <pre>{@code
 * AtomicFile.write(Path.of("report.json"), report.toJson());
 * }</pre>
 */
public final class AtomicFile {

    /** How the names of files end that are not finished. */
    public static final String UNFINISHED = ".part";

    private static final int DIGITS = 8;

    private AtomicFile() {}

    /**
     * Writes a text in UTF-8; a file of the same name is replaced.
     *
     * @param file the file
     * @param text all of its text
     * @throws UnwritableFileException if the file cannot be written; nothing is left behind then
     */
    public static void write(Path file, String text) throws UnwritableFileException {
        write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Writes bytes; a file of the same name is replaced. Of two programs that do it at the same time the later one wins.
     *
     * @param file the file
     * @param bytes all of its bytes
     * @throws UnwritableFileException if the file cannot be written; nothing is left behind then
     */
    public static void write(Path file, byte[] bytes) throws UnwritableFileException {
        String own = UUID.randomUUID().toString().substring(0, DIGITS);
        Path part = file.resolveSibling(
                "." + own + UNFINISHED); // the longest name that a file can have leaves no room for more
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
     * Names a file that is still being written, by a program that lets others see how it grows.
     *
     * @param file its name when it is finished
     * @return its name until then
     */
    public static Path part(Path file) {
        return file.resolveSibling(file.getFileName() + UNFINISHED);
    }

    /**
     * Begins to write {@link #part}. While the stream is open, no other program can begin with the same file.
     *
     * @param file its name when it is finished
     * @return the stream; what it throws is worded as {@link UnwritableFileException}
     * @throws UnwritableFileException if the file cannot be written, or another program is writing it
     */
    public static OutputStream begin(Path file) throws UnwritableFileException {
        try {
            FileChannel channel = FileChannel.open(part(file), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            if (FolderLock.isTaken(channel)) {
                channel.close();
                throw UnwritableFileException.isInUse(file);
            }
            channel.truncate(0);
            return new PartStream(file, Channels.newOutputStream(channel));
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /**
     * Gives a file its name when all of it has been written to {@link #part}; a file of the same name is replaced.
     *
     * @param file the file
     * @throws UnwritableFileException if it cannot be moved
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

    /** Words what goes wrong. */
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
