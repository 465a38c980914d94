package org.robonewbie.learning.optimise;

import org.jspecify.annotations.Nullable;
import org.robonewbie.learning.trial.TrialObserver;
import org.robonewbie.learning.trial.TrialRobot;
import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.measure.KickDistance;
import org.robonewbie.trial.measure.Turn;

/** Looks at a robot in each cycle, measures it and remembers what it does, until it is closed. */
final class MeasuringEye implements TrialObserver {

    private final Measure measure;
    private final Turn turn = new Turn();
    private final KickDistance kick = new KickDistance();
    private @Nullable Place first;
    private Vector3 last = Vector3.ZERO;
    private boolean closed;

    MeasuringEye(Measure measure) {
        this.measure = measure;
    }

    @Override
    public boolean goOn(TrialRobot robot) {
        if (closed) {
            return true;
        }
        Moment now = robot.now();
        if (first == null) {
            first = now.place();
        }
        last = now.robot().position();
        turn.see(now);
        kick.see(now);
        measure.see(now);
        return true;
    }

    /** Measures no more. */
    void close() {
        closed = true;
    }

    double value() {
        return measure.value();
    }

    Deed deed() {
        return first == null
                ? new Deed(0, 0, 0, 0)
                : new Deed(first.ahead(last), first.left(last), turn.value(), kick.value());
    }
}
