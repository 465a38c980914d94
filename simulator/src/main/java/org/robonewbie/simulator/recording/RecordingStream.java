package org.robonewbie.simulator.recording;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.zip.GZIPOutputStream;

/**
 * Where the bytes of a recording go: into a checksum and, if wanted, compressed into a file. The file grows as {@code
 * NAME.part}, so that a program that is killed leaves what it has recorded, and gets its name at the end.
 */
final class RecordingStream implements AutoCloseable {

    private static final int BUFFER_BYTES = 1 << 14;
    private static final int FLUSHES_PER_TIDYING = 30;

    private final MessageDigest digest;
    private final Consumer<String> console;
    private final Optional<Path> file;
    private final Optional<RecordingShelf> shelf;
    private Optional<OutputStream> out;
    private long flushes;

    private RecordingStream(
            Optional<Path> file, Optional<OutputStream> out, Optional<RecordingShelf> shelf, Consumer<String> console) {
        this.file = file;
        this.out = out;
        this.console = console;
        this.shelf = shelf;
        try {
            digest = MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("This Java has no SHA-256, which every Java must have", e);
        }
    }

    /**
     * Begins a stream.
     *
     * @param file the file to write, or empty for the checksum only
     * @param console takes sentences for people
     * @return the stream
     * @throws IOException if the file cannot be written; the message says what to do
     */
    static RecordingStream open(Optional<Path> file, Consumer<String> console) throws IOException {
        return open(file, file.flatMap(RecordingShelf::of), console);
    }

    static RecordingStream open(Optional<Path> file, Optional<RecordingShelf> shelf, Consumer<String> console)
            throws IOException {
        if (file.isEmpty()) {
            return new RecordingStream(file, Optional.empty(), Optional.empty(), console);
        }
        try {
            OutputStream raw = Files.newOutputStream(part(file.get()));
            OutputStream packed = new GZIPOutputStream(raw, BUFFER_BYTES, true);
            return new RecordingStream(file, Optional.of(packed), shelf, console);
        } catch (IOException e) {
            throw new IOException(
                    "Recording \"" + file.get() + "\" cannot be written (" + e.getMessage()
                            + "). Choose a file in a folder that exists and in which you may write.",
                    e);
        }
    }

    void write(ByteSink sink) {
        digest.update(sink.bytes(), 0, sink.length());
        attempt(stream -> stream.write(sink.bytes(), 0, sink.length()));
    }

    /** Brings all that was written into the file. */
    void flush() {
        attempt(OutputStream::flush);
        flushes++;
        if (flushes % FLUSHES_PER_TIDYING == 0 && out.isPresent() && !isWithinLimit()) {
            console.accept(
                    "The recording " + file.orElseThrow()
                            + " ends here because recordings have taken all the room that they may take. The simulation goes on.");
            close();
        }
    }

    private boolean isWithinLimit() {
        Path target = file.orElseThrow();
        return shelf.isEmpty() || shelf.get().keepLimit(target);
    }

    /** Tells the checksum of all bytes so far. */
    String sha256() {
        try {
            return HexFormat.of().formatHex(((MessageDigest) digest.clone()).digest());
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException("The checksum cannot be read", e);
        }
    }

    @Override
    public void close() {
        attempt(OutputStream::close);
        if (out.isPresent() && file.isPresent()) {
            attempt(stream -> moveIntoPlace(file.get()));
        }
        out = Optional.empty();
    }

    private interface Action {
        void on(OutputStream stream) throws IOException;
    }

    /** A full disk ends the recording, never the simulation. */
    private void attempt(Action action) {
        if (out.isPresent()) {
            try {
                action.on(out.get());
            } catch (IOException e) {
                out = Optional.empty();
                console.accept("The recording " + file.orElseThrow() + " ends here because it cannot be written ("
                        + e.getMessage() + "). Is the disk full? The simulation goes on.");
            }
        }
    }

    private static Path part(Path file) {
        return file.resolveSibling(file.getFileName() + ".part");
    }

    private static void moveIntoPlace(Path file) throws IOException {
        try {
            Files.move(part(file), file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(part(file), file, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
