package org.robonewbie.protocol.telemetry;

import java.util.List;
import java.util.Optional;

/** One thing that a robot tells about its thoughts. */
public sealed interface TelemetryItem {

    /**
     * A line of the robot's log, or a mistake in its program.
     *
     * @param level {@code DEBUG}, {@code INFO}, {@code WARNING} or {@code ERROR}
     * @param text what it says, possibly several lines
     */
    record LogEntry(String level, String text) implements TelemetryItem {}

    /**
     * The motion that the robot plays; told whenever it changes.
     *
     * @param name name of the motion; empty if none is running
     * @param keyframe the keyframe that is approached, from 1; 0 if none is running
     */
    record MotionProgress(String name, int keyframe) implements TelemetryItem {}

    /**
     * What the robot believes to be around it; told with each picture of its camera. It replaces the belief before.
     *
     * @param things all that it knows
     * @param self where it believes to be; empty if it does not care
     */
    record Belief(List<BelievedThing> things, Optional<BelievedPose> self) implements TelemetryItem {

        /**
         * Keeps a belief.
         *
         * @param things all that it knows
         * @param self where it believes to be
         */
        public Belief {
            things = List.copyOf(things);
        }
    }

    /**
     * What the robot has drawn in one cycle. It replaces the picture before and is out of date after a second.
     *
     * @param drawings the shapes, in the order in which they were drawn
     */
    record Picture(List<Drawing> drawings) implements TelemetryItem {

        /**
         * Keeps a picture.
         *
         * @param drawings the shapes
         */
        public Picture {
            drawings = List.copyOf(drawings);
        }
    }

    /**
     * A number to be plotted over time.
     *
     * @param name name of the curve
     * @param value its value now, finite
     */
    record PlotValue(String name, double value) implements TelemetryItem {}
}
