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
 * A recording as a compressed file. It grows as {@code NAME.part}, so that a program that is killed leaves what it has recorded,
 * and gets its name at the end.
 */
public final class RecordingFile implements RecordingTarget {

    private static final int BUFFER_BYTES = 1 << 14;
    private static final int FLUSHES_PER_TIDYING = 30;

    private final Path file;
    private final Optional<RecordingRepository> shelf;
    private final Consumer<String> console;
    private @Nullable OutputStream out;
    private long flushes;

    private RecordingFile(Path file, OutputStream out, Optional<RecordingRepository> shelf, Consumer<String> console) {
        this.file = file;
        this.out = out;
        this.shelf = shelf;
        this.console = console;
    }

    /**
     * Begins a file.
     *
     * @param file the file to write
     * @param console takes sentences for people
     * @return the file, still empty
     * @throws IOException if it cannot be written; the message says what to do
     */
    public static RecordingFile open(Path file, Consumer<String> console) throws IOException {
        return open(file, RecordingRepository.of(file), console);
    }

    /**
     * Begins a file if one is wanted.
     *
     * @param file the file to write; empty for none
     * @param console takes sentences for people
     * @return where the recording goes
     * @throws IOException if the file cannot be written; the message says what to do
     */
    public static RecordingTarget openIfWanted(Optional<Path> file, Consumer<String> console) throws IOException {
        return file.isPresent() ? open(file.get(), console) : RecordingTarget.NONE;
    }

    static RecordingFile open(Path file, Optional<RecordingRepository> shelf, Consumer<String> console)
            throws IOException {
        OutputStream raw = AtomicFile.begin(file);
        return new RecordingFile(file, new GZIPOutputStream(raw, BUFFER_BYTES, true), shelf, console);
    }

    /**
     * Opens a recording for reading.
     *
     * @param file a recording
     * @return the reader, before the first cycle
     * @throws IOException if the file cannot be read or is no recording; the message says so
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
        if (flushes % FLUSHES_PER_TIDYING == 0 && out != null && !isWithinLimit()) {
            console.accept(
                    "The recording " + file
                            + " ends here because recordings have taken all the room that they may take. The simulation goes on.");
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
        return shelf.isEmpty() || shelf.get().keepLimit(file);
    }

    /** What has been recorded stays, unless that is nothing. */
    private void abandon(OutputStream broken) {
        try {
            broken.close();
        } catch (IOException again) {
            console.accept("The rest of the recording is lost.");
        }
        try {
            if (Files.size(AtomicFile.part(file)) == 0) {
                Files.delete(AtomicFile.part(file));
            }
        } catch (IOException gone) {
            // Then there is nothing to tidy up.
        }
    }

    private interface Action {
        void on(OutputStream stream) throws IOException;
    }

    /** A full disk ends the recording, never the simulation. */
    private void attempt(Action action) {
        if (out != null) {
            try {
                action.on(out);
            } catch (IOException e) {
                abandon(out);
                out = null;
                console.accept("The recording " + file + " ends here because it cannot be written. " + e.getMessage()
                        + " The simulation goes on.");
            }
        }
    }
}
