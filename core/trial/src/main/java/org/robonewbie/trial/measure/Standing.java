package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** The time until the robot falls, in seconds. The measurement ends with the fall. */
public final class Standing extends MeasureFromStart {

    private double seconds;

    /** Creates the measure. */
    public Standing() {
        super("s", true);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (!hasFallen()) {
            seconds = now.seconds() - first.seconds();
        }
    }

    @Override
    public double value() {
        return seconds;
    }

    @Override
    public boolean isDecided() {
        return hasFallen();
    }
}
