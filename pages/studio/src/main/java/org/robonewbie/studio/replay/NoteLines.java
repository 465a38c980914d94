package org.robonewbie.studio.replay;

import com.google.gson.JsonObject;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** Chooses what is kept beside a recording of what robots log and draw, so that a replay shows it, and writes it as lines of JSON. */
public final class NoteLines {

    private static final int MOST_ENTRIES = 2000;
    private static final int MOST_LETTERS = 400;
    private static final int MOST_DRAWN_LETTERS = 4_000_000;
    private static final double PICTURE_SECONDS = 0.099;

    private final Map<String, Double> lastPictures = new HashMap<>();
    private int entries;
    private int drawnLetters;

    /**
     * Writes an entry of a log, of which a run has at most two thousand, or a picture, of which each robot has at most ten per
     * second, up to four million letters in a run.
     *
     * @param message what a robot tells
     * @return the line; empty if it is not kept
     */
    public Optional<String> of(TelemetryMessage message) {
        if (message.item() instanceof LogEntry entry) {
            return entry.level().equals("DEBUG") || entries >= MOST_ENTRIES
                    ? Optional.empty()
                    : Optional.of(line(message, entry));
        }
        return message.item() instanceof Picture && isDue(message) ? picture(message) : Optional.empty();
    }

    private String line(TelemetryMessage message, LogEntry entry) {
        entries++;
        JsonObject line = new JsonObject();
        line.addProperty("seconds", message.seconds());
        line.addProperty("robot", robot(message));
        line.addProperty("level", entry.level());
        line.addProperty(
                "text",
                entry.text().substring(0, Math.min(MOST_LETTERS, entry.text().length())));
        return line.toString();
    }

    private boolean isDue(TelemetryMessage message) {
        double last = lastPictures.getOrDefault(robot(message), Double.NEGATIVE_INFINITY);
        return message.seconds() < last || message.seconds() >= last + PICTURE_SECONDS;
    }

    private Optional<String> picture(TelemetryMessage message) {
        lastPictures.put(robot(message), message.seconds());
        JsonObject json = new JsonObject();
        json.addProperty("drawn", TelemetryLine.write(message));
        String line = json.toString();
        if (drawnLetters + line.length() > MOST_DRAWN_LETTERS) {
            return Optional.empty();
        }
        drawnLetters += line.length();
        return Optional.of(line);
    }

    private static String robot(TelemetryMessage message) {
        return (message.team() + " " + message.number()).strip();
    }
}
