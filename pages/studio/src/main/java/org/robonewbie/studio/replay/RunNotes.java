package org.robonewbie.studio.replay;

import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.file.RecordingGroup;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.file.PlainFile;

/**
 * Stores the robots' log entries and drawings as JSON lines alongside the recording of the run. They are not part of
 * the recording, so that the recording depends only on the seed, not on which robots are watched.
 */
public final class RunNotes {

    private final Optional<RecordingRepository> repository;
    private final NoteLines lines = new NoteLines();
    private Optional<Path> file = Optional.empty();
    private boolean diskFull;

    /**
     * Creates the notes for the run that is being recorded.
     *
     * @param repository the recordings; empty if nothing is recorded
     */
    public RunNotes(Optional<RecordingRepository> repository) {
        this.repository = repository;
    }

    /**
     * Stores a log entry or drawing if there is a recording to which it belongs.
     *
     * @param message telemetry of a robot
     */
    public void keep(TelemetryMessage message) {
        if (!diskFull) {
            lines.of(message).ifPresent(this::write);
        }
    }

    private void write(String line) {
        try {
            if (file.isEmpty()) {
                file = begin();
            }
            if (file.isPresent()) {
                Files.write(file.get(), List.of(line), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
            }
        } catch (IOException full) {
            diskFull = true;
        }
    }

    /** Finds the notes file of the recording in progress, and deletes the notes of recordings that no longer exist. */
    private Optional<Path> begin() throws IOException {
        if (repository.isEmpty()) {
            return Optional.empty();
        }
        try {
            repository.get().tidyUp();
        } catch (NoSuchFileException nothingRecordedYet) {
            return Optional.empty();
        }
        return repository.get().list().stream()
                .filter(RecordingFolders::isRunning)
                .findFirst()
                .map(RunNotes::of);
    }

    /** Returns the notes file of a recording. */
    static Path of(Path recording) {
        return new RecordingGroup(recording).beside(RecordingGroup.NOTES);
    }

    /**
     * Reads the notes of a recording.
     *
     * @param recording the recording
     * @param skipped number of bytes to skip
     * @return complete lines only; empty if there are no notes
     */
    static byte[] read(Path recording, long skipped) throws IOException {
        if (!Files.isRegularFile(of(recording)) || !PlainFile.isInItsFolder(of(recording))) {
            return new byte[0];
        }
        try (SeekableByteChannel channel = Files.newByteChannel(of(recording))) {
            channel.position(Math.min(skipped, channel.size()));
            byte[] bytes = Channels.newInputStream(channel).readAllBytes();
            int end = bytes.length;
            while (end > 0 && bytes[end - 1] != '\n') {
                end--;
            }
            return Arrays.copyOf(bytes, end);
        } catch (NoSuchFileException none) {
            return new byte[0];
        }
    }
}
