package org.robonewbie.studio;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** Latest log lines and motion events of each robot, for pages that select it later. Not thread-safe. */
final class TelemetryHistory {

    private static final int MAX_MESSAGES = 500;

    private final Map<String, Deque<TelemetryMessage>> robots = new HashMap<>();

    /** Returns the unique key of a robot. */
    static String key(String team, int number) {
        return team + "\t" + number;
    }

    void keep(TelemetryMessage message) {
        if (message.item() instanceof TelemetryItem.LogEntry
                || message.item() instanceof TelemetryItem.MotionProgress) {
            Deque<TelemetryMessage> kept =
                    robots.computeIfAbsent(key(message.team(), message.number()), robot -> new ArrayDeque<>());
            kept.add(message);
            if (kept.size() > MAX_MESSAGES) {
                kept.remove();
            }
        }
    }

    /** Discards the telemetry of programs that have been replaced. */
    void clear() {
        robots.clear();
    }

    /** Returns the telemetry of a robot, oldest first. */
    List<TelemetryMessage> of(String robot) {
        return List.copyOf(robots.getOrDefault(robot, new ArrayDeque<>()));
    }
}
