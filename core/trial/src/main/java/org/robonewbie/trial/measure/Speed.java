package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** The mean speed of the robot along its initial heading, in metres per second. The time after a fall is included. */
public final class Speed extends MeasureFromStart {

    private final Distance distance = new Distance();
    private double seconds;

    /** Creates the measure. */
    public Speed() {
        super("m/s", true);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        distance.see(now);
        seconds = now.seconds() - first.seconds();
    }

    @Override
    public double value() {
        return seconds > 0 ? distance.value() / seconds : 0;
    }
}
