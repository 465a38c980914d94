package org.robonewbie.simulator.recording;

import java.util.List;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * One cycle of a recording.
 *
 * @param snapshot the world at the end of the cycle
 * @param commands the agents' commands
 * @param events match events, such as {@code goal left Stars}
 */
public record RecordedCycle(WorldSnapshot snapshot, List<RobotCommands> commands, List<String> events) {

    /** Makes the lists unmodifiable. */
    public RecordedCycle {
        commands = List.copyOf(commands);
        events = List.copyOf(events);
    }
}
