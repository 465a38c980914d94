package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** How long the robot keeps on its feet, in seconds; decided by its fall. */
public final class Standing extends MeasureFromStart {

    private double seconds;

    /** Creates a measure that has not seen anything. */
    public Standing() {}

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
    public String unit() {
        return "s";
    }

    @Override
    public boolean isDecided() {
        return hasFallen();
    }
}
