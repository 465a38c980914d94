package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.file.RecordingGroup;
import org.robonewbie.simulator.file.RecordingShelf;
import org.robonewbie.studio.file.PlainFile;

/**
 * Stores the robots' log lines and drawings next to the recording of the run, one line of JSON each, so that a replay shows them
 * on its time line and in its field. They are not part of the recording, which is the same for the same seed whoever watches.
 */
public final class RunNotes {

    private static final int MOST_NOTES = 2000;
    private static final int MOST_LETTERS = 400;
    private static final int MOST_DRAWN_LETTERS = 4_000_000;
    private static final double PICTURE_SECONDS = 0.099;

    private final Optional<RecordingShelf> shelf;
    private Optional<Path> file = Optional.empty();
    private int count;
    private final Map<String, Double> lastPictures = new HashMap<>();
    private int drawnLetters;

    /**
     * Opens the notes of the run that is being recorded.
     *
     * @param shelf where the recordings are; empty if nothing is recorded
     */
    public RunNotes(Optional<RecordingShelf> shelf) {
        this.shelf = shelf;
    }

    /**
     * Keeps a line of a log, of which a run has at most two thousand, and at most ten pictures of each robot per second, up to
     * four million letters in a run; anything else is left out.
     *
     * @param message what a robot tells
     */
    public void keep(TelemetryMessage message) {
        try {
            if (message.item() instanceof LogEntry entry) {
                keep(message, entry);
            } else if (message.item() instanceof Picture && isDue(message)) {
                keepPicture(message);
            }
        } catch (IOException diskFull) {
            count = MOST_NOTES;
            drawnLetters = MOST_DRAWN_LETTERS;
        }
    }

    private void keep(TelemetryMessage message, LogEntry entry) throws IOException {
        if (entry.level().equals("DEBUG") || count >= MOST_NOTES) {
            return;
        }
        JsonObject line = new JsonObject();
        line.addProperty("seconds", message.seconds());
        line.addProperty("robot", robot(message));
        line.addProperty("level", entry.level());
        line.addProperty(
                "text",
                entry.text().substring(0, Math.min(MOST_LETTERS, entry.text().length())));
        if (write(line.toString())) {
            count++;
        }
    }

    private boolean isDue(TelemetryMessage message) {
        double last = lastPictures.getOrDefault(robot(message), Double.NEGATIVE_INFINITY);
        return message.seconds() < last || message.seconds() >= last + PICTURE_SECONDS;
    }

    private void keepPicture(TelemetryMessage message) throws IOException {
        JsonObject json = new JsonObject();
        json.addProperty("drawn", TelemetryLine.write(message));
        String line = json.toString();
        if (drawnLetters + line.length() <= MOST_DRAWN_LETTERS && write(line)) {
            drawnLetters += line.length();
        }
        lastPictures.put(robot(message), message.seconds());
    }

    private static String robot(TelemetryMessage message) {
        return (message.team() + " " + message.number()).strip();
    }

    /** Adds a line, and returns whether there is a recording to which it belongs. */
    private boolean write(String line) throws IOException {
        if (file.isEmpty()) {
            file = begin();
        }
        if (file.isPresent()) {
            Files.write(file.get(), List.of(line), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        }
        return file.isPresent();
    }

    /** Opens the notes of the recording that is being written, and deletes notes whose recording is gone. */
    private Optional<Path> begin() throws IOException {
        if (shelf.isEmpty()) {
            return Optional.empty();
        }
        try {
            shelf.get().tidyUp();
        } catch (NoSuchFileException nothingRecordedYet) {
            return Optional.empty();
        }
        return shelf.get().list().stream()
                .filter(RecordingPlaces::isRunning)
                .findFirst()
                .map(RunNotes::of);
    }

    /** The notes that belong to a recording. */
    static Path of(Path recording) {
        return RecordingGroup.of(recording).beside(RecordingGroup.NOTES);
    }

    /**
     * Reads the notes of a recording, without those that are known already.
     *
     * @param recording the recording
     * @param skipped how many bytes are known
     * @return the lines behind them, only whole ones; nothing if there are no notes
     */
    static byte[] read(Path recording, long skipped) throws IOException {
        if (!PlainFile.isInItsFolder(of(recording))) {
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
