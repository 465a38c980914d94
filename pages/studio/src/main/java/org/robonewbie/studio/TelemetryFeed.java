package org.robonewbie.studio;

import com.google.gson.JsonObject;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.json.Json;

/**
 * Telemetry buffer of one page: all items and agent messages of the watched robot, and the latest drawing from every
 * other robot.
 */
final class TelemetryFeed {

    private static final int MAX_LINES = 2000;
    private static final int MAX_MESSAGES = 200;

    private final Deque<String> items = new ArrayDeque<>();
    private final Map<String, TelemetryMessage> pictures = new LinkedHashMap<>();
    private final Deque<AgentMessages> talk = new ArrayDeque<>();
    private volatile String watched = "";
    private volatile boolean isNew;
    private long lastCycle = -1;

    /** Selects the robot to watch. Thread-safe. */
    void watch(String robot) {
        watched = robot;
        isNew = true;
    }

    /** Returns whether a robot is being watched. Thread-safe. */
    boolean watches(String robot) {
        return watched.equals(robot);
    }

    /** Replays the history of a robot that has just been selected on the page. */
    void remember(TelemetryHistory memory) {
        if (isNew) {
            isNew = false;
            items.clear();
            talk.clear();
            lastCycle = -1;
            memory.of(watched).forEach(this::add);
        }
    }

    /** Adds telemetry of any robot. */
    void add(TelemetryMessage message) {
        String robot = TelemetryHistory.key(message.team(), message.number());
        if (watches(robot)) {
            items.add(TelemetryLine.write(message));
            if (items.size() > MAX_LINES) {
                items.remove();
            }
        } else if (message.item() instanceof TelemetryItem.Picture) {
            pictures.put(robot, message);
        }
    }

    /** Adds the messages of the watched robot's agent. */
    void add(String robot, AgentMessages messages) {
        if (watches(robot) && messages.cycle() != lastCycle) {
            lastCycle = messages.cycle();
            talk.add(messages);
            if (talk.size() > MAX_MESSAGES) {
                talk.remove();
            }
        }
    }

    /** Drains the buffer into one JSON object; returns empty if nothing is buffered. */
    Optional<String> take() {
        if (items.isEmpty() && talk.isEmpty() && pictures.isEmpty()) {
            return Optional.empty();
        }
        JsonObject json = Json.object(
                "kind",
                "telemetry",
                "robot",
                watched,
                "lines",
                items,
                "drawings",
                Json.array(pictures.values().stream().map(TelemetryLine::write)),
                "messages",
                Json.array(talk.stream().map(TelemetryFeed::exchanged)));
        items.clear();
        pictures.clear();
        talk.clear();
        return Optional.of(json.toString());
    }

    private static List<Object> exchanged(AgentMessages messages) {
        return List.of(messages.cycle(), messages.perceptors(), messages.effectors());
    }
}
