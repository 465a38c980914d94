package org.robonewbie.studio.replay;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.protocol.telemetry.TelemetryItem.LogEntry;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.json.Json;

/** Selects the log entries and drawings that are stored alongside a recording, and writes them as JSON lines. */
public final class NoteLines {

    private static final int MAX_ENTRIES = 2000;
    private static final int MAX_CHARACTERS = 400;
    private static final int MAX_DRAWN_CHARACTERS = 4_000_000;
    private static final double PICTURE_SECONDS = 0.099;

    private final Map<String, Double> lastPictures = new HashMap<>();
    private int entries;
    private int drawnCharacters;

    /**
     * Converts a telemetry message to a line. Keeps at most 2,000 log entries per run, ten drawings per second for each
     * robot, and four million characters of drawings per run.
     *
     * @param message telemetry of a robot
     * @return the line; empty if the message is not kept
     */
    public Optional<String> of(TelemetryMessage message) {
        if (message.item() instanceof LogEntry entry) {
            return entry.level().equals("DEBUG") || entries >= MAX_ENTRIES
                    ? Optional.empty()
                    : Optional.of(line(message, entry));
        }
        return message.item() instanceof Picture && isDue(message) ? picture(message) : Optional.empty();
    }

    private String line(TelemetryMessage message, LogEntry entry) {
        entries++;
        String text =
                entry.text().substring(0, Math.min(MAX_CHARACTERS, entry.text().length()));
        return Json.object("seconds", message.seconds(), "robot", robot(message), "level", entry.level(), "text", text)
                .toString();
    }

    private boolean isDue(TelemetryMessage message) {
        double last = lastPictures.getOrDefault(robot(message), Double.NEGATIVE_INFINITY);
        return message.seconds() < last || message.seconds() >= last + PICTURE_SECONDS;
    }

    private Optional<String> picture(TelemetryMessage message) {
        lastPictures.put(robot(message), message.seconds());
        String line = Json.object("drawn", TelemetryLine.write(message)).toString();
        if (drawnCharacters + line.length() > MAX_DRAWN_CHARACTERS) {
            return Optional.empty();
        }
        drawnCharacters += line.length();
        return Optional.of(line);
    }

    private static String robot(TelemetryMessage message) {
        return (message.team() + " " + message.number()).strip();
    }
}
