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

/** Publishes a robot's telemetry; costs almost nothing while there is no viewer. */
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
     * @param viewer receives the telemetry from now on
     */
    public void publishTo(TelemetrySink viewer) {
        sink = viewer;
    }

    /** {@return whether there is a viewer} */
    public boolean isWatched() {
        return sink.isWanted();
    }

    void publish(LogLine line) {
        if (isWatched()) {
            publish(line.seconds(), new TelemetryItem.LogEntry(line.level().name(), line.text()));
        }
    }

    /**
     * Adds a value to a plot.
     *
     * @param name name of the curve
     * @param value the value
     */
    public void plot(String name, double value) {
        if (isWatched() && Double.isFinite(value)) {
            publish(new TelemetryItem.PlotValue(name, value));
        }
    }

    /**
     * Removes and returns the value that a viewer has requested for a tunable number.
     *
     * @param name name of the number
     * @return the requested value; empty if there is no request
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
     * Sets the estimated pose, which is published with the next belief.
     *
     * @param pose the pose
     */
    public void locate(Pose2d pose) {
        self = Optional.of(pose);
    }

    /** Publishes the robot's beliefs about the field; called after each new camera picture. */
    void publishBelief(LocalFieldView view) {
        if (isWatched()) {
            publish(new TelemetryItem.Belief(things(view), self));
        }
    }

    /** Publishes drawings and motion progress at the end of a cycle. */
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

    /**
     * Publishes an item for the current cycle.
     *
     * @param item the item
     */
    public void publish(TelemetryItem item) {
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
