package org.robonewbie.simulator.recording;

import java.util.List;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * One cycle of a recording.
 *
 * @param snapshot the world at its end, as an observer of the run saw it
 * @param commands what agents commanded
 * @param events what happened, such as {@code goal left Stars}
 */
public record RecordedCycle(WorldSnapshot snapshot, List<RobotCommands> commands, List<String> events) {

    /** Makes the lists unmodifiable. */
    public RecordedCycle {
        commands = List.copyOf(commands);
        events = List.copyOf(events);
    }
}
