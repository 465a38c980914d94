package org.robonewbie.simulator.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.zip.GZIPOutputStream;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingTarget;

/**
 * A recording as a gzip file. It is written as {@code NAME.part} and renamed when it is closed. If the program is killed,
 * a partial but readable recording remains.
 */
public final class RecordingFile implements RecordingTarget {

    private static final int BUFFER_BYTES = 1 << 14;
    private static final int FLUSHES_PER_SIZE_CHECK = 30;

    private final Path file;
    private final Optional<RecordingRepository> repository;
    private final Consumer<String> console;
    private @Nullable OutputStream out;
    private long flushes;

    private RecordingFile(
            Path file, OutputStream out, Optional<RecordingRepository> repository, Consumer<String> console) {
        this.file = file;
        this.out = out;
        this.repository = repository;
        this.console = console;
    }

    /**
     * Creates a file.
     *
     * @param file the file to write
     * @param console output for messages to the user
     * @return the empty recording
     * @throws IOException if it cannot be written; the message says what to do
     */
    public static RecordingFile open(Path file, Consumer<String> console) throws IOException {
        return open(file, RecordingRepository.of(file), console);
    }

    /**
     * Creates a file if one is given.
     *
     * @param file the file to write; empty for none
     * @param console output for messages to the user
     * @return the target of the recording
     * @throws IOException if the file cannot be written; the message says what to do
     */
    public static RecordingTarget openIfWanted(Optional<Path> file, Consumer<String> console) throws IOException {
        return file.isPresent() ? open(file.get(), console) : RecordingTarget.NONE;
    }

    static RecordingFile open(Path file, Optional<RecordingRepository> repository, Consumer<String> console)
            throws IOException {
        OutputStream raw = AtomicFile.begin(file);
        return new RecordingFile(file, new GZIPOutputStream(raw, BUFFER_BYTES, true), repository, console);
    }

    /**
     * Opens a recording for reading.
     *
     * @param file a recording
     * @return the reader, positioned before the first cycle
     * @throws IOException if the file cannot be read or is not a recording
     */
    public static RecordingReader read(Path file) throws IOException {
        InputStream raw = Files.newInputStream(file);
        try {
            return RecordingReader.of(raw, "\"" + file + "\"");
        } catch (IOException e) {
            raw.close();
            throw e;
        }
    }

    @Override
    public void write(byte[] bytes, int length) {
        attempt(stream -> stream.write(bytes, 0, length));
    }

    @Override
    public void flush() {
        attempt(OutputStream::flush);
        flushes++;
        if (flushes % FLUSHES_PER_SIZE_CHECK == 0 && out != null && !isWithinLimit()) {
            console.accept("The recording " + file
                    + " ends here because it has reached the size limit for recordings. The simulation continues.");
            close();
        }
    }

    @Override
    public void close() {
        attempt(OutputStream::close);
        attempt(stream -> AtomicFile.moveIntoPlace(file));
        out = null;
    }

    private boolean isWithinLimit() {
        return repository.isEmpty() || repository.get().keepLimit(file);
    }

    /** Closes the stream and deletes the file if it is empty. */
    private void abandon(OutputStream broken) {
        try {
            broken.close();
        } catch (IOException e) {
            console.accept("The last part of the recording could not be written.");
        }
        try {
            if (Files.size(AtomicFile.part(file)) == 0) {
                Files.delete(AtomicFile.part(file));
            }
        } catch (IOException missing) {
            // There is no file to delete.
        }
    }

    private interface Action {
        void on(OutputStream stream) throws IOException;
    }

    /** Performs an action. A failure, such as a full disk, stops the recording but not the simulation. */
    private void attempt(Action action) {
        if (out != null) {
            try {
                action.on(out);
            } catch (IOException e) {
                abandon(out);
                out = null;
                console.accept("The recording " + file + " ends here because it cannot be written. " + e.getMessage()
                        + " The simulation continues.");
            }
        }
    }
}
