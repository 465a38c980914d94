package org.robonewbie.agent.cycle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.agent.log.LogLine;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.agent.walk.WalkController;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequests;

/** Publishes what a robot thinks; this costs next to nothing while there is no viewer. */
public final class TelemetryPublisher {

    private static final Landmark[] LANDMARKS = Landmark.values();
    private static final int MAX_DRAWINGS = 1000;

    private final SensorState sensors;
    private final List<Drawing> drawings = new ArrayList<>();
    private volatile TelemetrySink sink = TelemetrySink.NONE;
    private Optional<String> motion = Optional.empty();
    private Optional<Pose2d> self = Optional.empty();
    private int keyframe;

    TelemetryPublisher(SensorState sensors) {
        this.sensors = sensors;
    }

    /**
     * Sets the viewer.
     *
     * @param viewer receives what the robot thinks from now on
     */
    public void publishTo(TelemetrySink viewer) {
        sink = viewer;
    }

    /** {@return whether there is a viewer} */
    public boolean isWatched() {
        return sink.isWanted();
    }

    /** Publishes a line of the log at once. */
    void publish(LogLine line) {
        if (isWatched()) {
            publish(line.seconds(), new TelemetryItem.LogEntry(line.level().name(), line.text()));
        }
    }

    /**
     * Adds a value to a curve.
     *
     * @param name the curve's name
     * @param value the value
     */
    public void plot(String name, double value) {
        if (isWatched() && Double.isFinite(value)) {
            publish(new TelemetryItem.PlotValue(name, value));
        }
    }

    /**
     * Publishes a number of the robot's program that can be tuned.
     *
     * @param number the number
     */
    public void declare(TelemetryItem.DeclaredNumber number) {
        publish(number);
    }

    /**
     * Takes what somebody wants of a number of this robot.
     *
     * @param name what the program calls it
     * @return the wanted value; empty if nobody wants another one
     */
    public OptionalDouble wish(String name) {
        Optional<TuningRequests> wishes = sink.tuningRequests();
        return wishes.isPresent() ? wishes.get().take(sensors.team(), sensors.number(), name) : OptionalDouble.empty();
    }

    /**
     * Adds a drawing to the picture of this cycle.
     *
     * @param drawing the drawing
     */
    public synchronized void draw(Drawing drawing) {
        if (isWatched() && drawings.size() < MAX_DRAWINGS) {
            drawings.add(drawing);
        }
    }

    /**
     * Sets where the robot believes to be, for the next belief.
     *
     * @param pose the pose
     */
    public void locate(Pose2d pose) {
        self = Optional.of(pose);
    }

    /** Publishes what the robot believes, after it has seen something new. */
    void publishBelief(LocalFieldView view) {
        if (isWatched()) {
            publish(new TelemetryItem.Belief(things(view), self));
        }
    }

    /** Publishes what the robot does, at the end of a cycle. */
    synchronized void publishActions(WalkController walk) {
        if (!isWatched()) {
            drawings.clear();
            return;
        }
        if (!drawings.isEmpty()) {
            publish(new TelemetryItem.Picture(drawings));
            drawings.clear();
        }
        Optional<String> current = walk.current();
        if (!current.equals(motion) || walk.keyframe() != keyframe) {
            motion = current;
            keyframe = walk.keyframe();
            publish(new TelemetryItem.MotionProgress(motion.orElse(""), keyframe));
        }
    }

    private void publish(TelemetryItem item) {
        publish(sensors.seconds(), item);
    }

    private void publish(double seconds, TelemetryItem item) {
        sink.accept(new TelemetryMessage(sensors.team(), sensors.number(), seconds, item));
    }

    private static List<BelievedThing> things(LocalFieldView view) {
        List<BelievedThing> things = new ArrayList<>();
        add(things, "ball", view.ball());
        for (Landmark landmark : LANDMARKS) {
            add(things, landmark.name(), view.landmark(landmark));
        }
        for (PlayerItem player : view.players()) {
            add(things, player.team() + " " + player.number(), player);
        }
        return things;
    }

    private static void add(List<BelievedThing> things, String name, FieldItem item) {
        if (item.isKnown()) {
            things.add(new BelievedThing(name, item.position(), item.ageSeconds(), item.isVisible()));
        }
    }
}
