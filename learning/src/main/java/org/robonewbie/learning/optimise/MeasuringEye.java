package org.robonewbie.learning.optimise;

import org.jspecify.annotations.Nullable;
import org.robonewbie.learning.objective.Gauge;
import org.robonewbie.learning.objective.TrueState;
import org.robonewbie.learning.objective.TrueStateEye;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.learning.trial.TrialRobot;

/** Looks at a robot in each cycle, measures it with a gauge and remembers what it does, until it is closed. */
final class MeasuringEye implements TrialObserver {

    private static final double ROLLS_ON_SECONDS = 0.94;

    private final Gauge gauge;
    private @Nullable TrueStateEye eye;
    private @Nullable TrueState first;
    private @Nullable TrueState last;
    private double turnedDegrees;
    private boolean closed;

    MeasuringEye(Gauge gauge) {
        this.gauge = gauge;
    }

    @Override
    public boolean goOn(TrialRobot robot) {
        if (closed) {
            return true;
        }
        if (eye == null) {
            eye = robot.eye();
        }
        TrueState now = eye.look();
        if (first == null) {
            first = now;
        }
        if (last != null) {
            turnedDegrees += Math.IEEEremainder(now.headingDegrees() - last.headingDegrees(), 360);
        }
        last = now;
        gauge.look(now);
        return true;
    }

    /** Measures no more. */
    void close() {
        closed = true;
    }

    double value() {
        return gauge.value();
    }

    Deed deed() {
        if (first == null || last == null) {
            return new Deed(0, 0, 0, 0);
        }
        double ball = first.ahead(last.ball().plus(last.ballVelocity().times(ROLLS_ON_SECONDS)));
        return new Deed(
                first.ahead(last.torso()), first.left(last.torso()), turnedDegrees, ball - first.ahead(first.ball()));
    }
}
