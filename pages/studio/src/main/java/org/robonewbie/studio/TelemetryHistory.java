package org.robonewbie.studio;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** The last log lines and motions of each robot, for pages that begin to watch it later. Used by one thread only. */
final class TelemetryHistory {

    private static final int MOST_MESSAGES = 500;

    private final Map<String, Deque<TelemetryMessage>> robots = new HashMap<>();

    /** The key of a robot, unique among all robots. */
    static String key(String team, int number) {
        return team + "\t" + number;
    }

    void keep(TelemetryMessage message) {
        if (message.item() instanceof TelemetryItem.LogEntry
                || message.item() instanceof TelemetryItem.MotionProgress) {
            Deque<TelemetryMessage> kept =
                    robots.computeIfAbsent(key(message.team(), message.number()), robot -> new ArrayDeque<>());
            kept.add(message);
            if (kept.size() > MOST_MESSAGES) {
                kept.remove();
            }
        }
    }

    /** The telemetry of a robot, oldest first. */
    List<TelemetryMessage> of(String robot) {
        return List.copyOf(robots.getOrDefault(robot, new ArrayDeque<>()));
    }
}
