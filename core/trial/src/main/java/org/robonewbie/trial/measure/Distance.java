package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** The distance that the robot covers along its initial heading before it falls, in metres. */
public final class Distance extends MeasureFromStart {

    private double metres;

    /** Creates the measure. */
    public Distance() {
        super("m", true);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        if (!hasFallen()) {
            metres = first.place().ahead(now.robot().position());
        }
    }

    @Override
    public double value() {
        return metres;
    }
}
