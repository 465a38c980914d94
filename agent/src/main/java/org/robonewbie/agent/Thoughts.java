package org.robonewbie.agent;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.LogLine;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.agent.perception.LocalFieldView;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.nao.Landmark;
import org.robonewbie.protocol.telemetry.BelievedPose;
import org.robonewbie.protocol.telemetry.BelievedThing;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** Tells whoever watches what a robot thinks; costs next to nothing while nobody does. */
final class Thoughts {

    private static final Landmark[] LANDMARKS = Landmark.values();
    private static final int MOST_DRAWINGS = 1000;

    private final Senses senses;
    private final List<Drawing> drawings = new ArrayList<>();
    private volatile TelemetrySink sink = TelemetrySink.NONE;
    private Optional<String> motion = Optional.empty();
    private Optional<BelievedPose> self = Optional.empty();
    private int keyframe;

    Thoughts(Senses senses) {
        this.senses = senses;
    }

    /** Finds somebody who watches. */
    void tellTo(TelemetrySink watcher) {
        sink = watcher;
    }

    boolean isWatched() {
        return sink.isWanted();
    }

    /** Tells a line of the log at once. */
    void log(LogLine line) {
        if (isWatched()) {
            tell(line.seconds(), new TelemetryItem.LogEntry(line.level().name(), line.text()));
        }
    }

    void plot(String name, double value) {
        if (isWatched() && Double.isFinite(value)) {
            tell(new TelemetryItem.PlotValue(name, value));
        }
    }

    synchronized void draw(Drawing drawing) {
        if (isWatched() && drawings.size() < MOST_DRAWINGS) {
            drawings.add(drawing);
        }
    }

    /** Takes in where the robot believes to be, for the next belief. */
    void locate(BelievedPose pose) {
        self = Optional.of(pose);
    }

    /** Tells what the robot believes, after it has seen something new. */
    void believe(LocalFieldView view) {
        if (isWatched()) {
            tell(new TelemetryItem.Belief(things(view), self));
        }
    }

    /** Tells what the robot does, at the end of a cycle. */
    synchronized void act(Walk walk) {
        if (!isWatched()) {
            drawings.clear();
            return;
        }
        if (!drawings.isEmpty()) {
            tell(new TelemetryItem.Picture(drawings));
            drawings.clear();
        }
        Optional<String> current = walk.current();
        if (!current.equals(motion) || walk.keyframe() != keyframe) {
            motion = current;
            keyframe = walk.keyframe();
            tell(new TelemetryItem.MotionProgress(motion.orElse(""), keyframe));
        }
    }

    private void tell(TelemetryItem item) {
        tell(senses.seconds(), item);
    }

    private void tell(double seconds, TelemetryItem item) {
        sink.accept(new TelemetryMessage(senses.team(), senses.number(), seconds, item));
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
