package org.robonewbie.protocol.telemetry;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.geometry.Pose2d;

/** One item of a robot's telemetry. */
public sealed interface TelemetryItem {

    /**
     * A line of the robot's log, or an error in its program.
     *
     * @param level {@code DEBUG}, {@code INFO}, {@code WARNING} or {@code ERROR}
     * @param text the message, possibly several lines
     */
    record LogEntry(String level, String text) implements TelemetryItem {}

    /**
     * The motion that the robot plays; sent whenever it changes.
     *
     * @param name name of the motion; empty if none is running
     * @param keyframe the keyframe that is approached, from 1; 0 if none is running
     */
    record MotionProgress(String name, int keyframe) implements TelemetryItem {}

    /**
     * What the robot believes to be around it; sent with each picture of its camera. It replaces the previous belief.
     *
     * @param things everything that it knows
     * @param self its believed pose; empty if it does not keep one
     */
    record Belief(List<BelievedThing> things, Optional<Pose2d> self) implements TelemetryItem {

        /**
         * Creates a belief.
         *
         * @param things everything that it knows
         * @param self its believed pose
         */
        public Belief {
            things = List.copyOf(things);
        }
    }

    /**
     * What the robot has drawn in one cycle. It replaces the previous picture and expires after a second.
     *
     * @param drawings the shapes, in the order in which they were drawn
     */
    record Picture(List<Drawing> drawings) implements TelemetryItem {

        /**
         * Creates a picture.
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
     * @param value its present value, finite
     */
    record PlotValue(String name, double value) implements TelemetryItem {}

    /**
     * A number that the robot's program has declared and that can be tuned while it runs; sent now and then.
     *
     * @param name what the program calls it
     * @param usual its value in the program's text
     * @param least its smallest value
     * @param most its largest value
     * @param value its present value
     */
    record DeclaredNumber(String name, double usual, double least, double most, double value)
            implements TelemetryItem {}
}
