package org.robonewbie.studio;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.simulator.AgentMessages;

/**
 * What one page hears of robots until it is ready for it: all that the watched robot tells, says and hears, and the newest picture
 * that each other robot draws.
 */
final class TelemetryFeed {

    private static final int MOST_LINES = 2000;
    private static final int MOST_MESSAGES = 200;

    private final Deque<String> heard = new ArrayDeque<>();
    private final Map<String, TelemetryMessage> pictures = new LinkedHashMap<>();
    private final Deque<AgentMessages> talk = new ArrayDeque<>();
    private volatile String watched = "";
    private volatile boolean begins;
    private long toldCycle = -1;

    /** Chooses the robot; may be called from any thread. */
    void watch(String robot) {
        watched = robot;
        begins = true;
    }

    /** Whether a robot is the chosen one; may be called from any thread. */
    boolean watches(String robot) {
        return watched.equals(robot);
    }

    /** Takes the telemetry from before the page began to watch. */
    void remember(TelemetryHistory memory) {
        if (begins) {
            begins = false;
            heard.clear();
            talk.clear();
            toldCycle = -1;
            memory.of(watched).forEach(this::hear);
        }
    }

    /** Keeps what a robot tells. */
    void hear(TelemetryMessage message) {
        String robot = TelemetryHistory.key(message.team(), message.number());
        if (watches(robot)) {
            heard.add(TelemetryLine.write(message));
            if (heard.size() > MOST_LINES) {
                heard.remove();
            }
        } else if (message.item() instanceof TelemetryItem.Picture) {
            pictures.put(robot, message);
        }
    }

    /** Keeps what the watched robot's agent says and hears. */
    void hear(String robot, AgentMessages messages) {
        if (watches(robot) && messages.cycle() != toldCycle) {
            toldCycle = messages.cycle();
            talk.add(messages);
            if (talk.size() > MOST_MESSAGES) {
                talk.remove();
            }
        }
    }

    /** Takes all of it as one JSON object; empty if there is nothing. */
    Optional<String> take() {
        if (heard.isEmpty() && talk.isEmpty() && pictures.isEmpty()) {
            return Optional.empty();
        }
        JsonObject json = new JsonObject();
        json.addProperty("kind", "telemetry");
        json.addProperty("robot", watched);
        json.add("lines", lines());
        json.add("drawings", drawings());
        json.add("messages", exchanged());
        return Optional.of(json.toString());
    }

    private JsonArray lines() {
        JsonArray lines = new JsonArray();
        heard.forEach(lines::add);
        heard.clear();
        return lines;
    }

    private JsonArray drawings() {
        JsonArray drawings = new JsonArray();
        pictures.values().forEach(picture -> drawings.add(TelemetryLine.write(picture)));
        pictures.clear();
        return drawings;
    }

    private JsonArray exchanged() {
        JsonArray exchanged = new JsonArray();
        for (AgentMessages messages : talk) {
            JsonArray one = new JsonArray();
            one.add(messages.cycle());
            one.add(messages.perceptors());
            one.add(messages.effectors());
            exchanged.add(one);
        }
        talk.clear();
        return exchanged;
    }
}
