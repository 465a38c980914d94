package org.robonewbie.protocol.telemetry;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.geometry.Pose2d;

/** An item of a robot's telemetry. */
public sealed interface TelemetryItem {

    /**
     * An entry in the robot's log, or a report of an error in its program.
     *
     * @param level {@code DEBUG}, {@code INFO}, {@code WARNING} or {@code ERROR}
     * @param text the message, which may have several lines
     */
    record LogEntry(String level, String text) implements TelemetryItem {}

    /**
     * Progress of the motion that the robot is playing; sent on each change.
     *
     * @param name name of the motion; empty if none is running
     * @param keyframe one-based number of the keyframe that the robot is approaching; 0 if no motion is running
     */
    record MotionProgress(String name, int keyframe) implements TelemetryItem {}

    /**
     * The robot's estimate of its surroundings; sent with each camera image. It replaces the previous one.
     *
     * @param things the known objects
     * @param self estimated pose of the robot; empty if the robot does not localise itself
     */
    record Belief(List<BelievedThing> things, Optional<Pose2d> self) implements TelemetryItem {

        /** Stores an unmodifiable copy of the list. */
        public Belief {
            things = List.copyOf(things);
        }
    }

    /**
     * The robot's drawings from one cycle. They replace the previous ones and expire after a second.
     *
     * @param drawings the shapes in drawing order
     */
    record Picture(List<Drawing> drawings) implements TelemetryItem {

        /** Stores an unmodifiable copy of the list. */
        public Picture {
            drawings = List.copyOf(drawings);
        }
    }

    /**
     * A value to plot over time.
     *
     * @param name name of the curve
     * @param value current value, finite
     */
    record PlotValue(String name, double value) implements TelemetryItem {}

    /**
     * A tunable parameter that the robot's program has declared; sent periodically.
     *
     * @param name name of the parameter in the program
     * @param defaultValue value in the source code of the program
     * @param min minimum value
     * @param max maximum value
     * @param value current value
     */
    record DeclaredNumber(String name, double defaultValue, double min, double max, double value)
            implements TelemetryItem {}
}
