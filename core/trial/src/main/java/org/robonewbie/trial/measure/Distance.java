package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** How far the robot gets along its first heading before it falls, in metres. */
public final class Distance extends MeasureFromStart {

    private double metres;

    /** Creates a measure that has not seen anything. */
    public Distance() {}

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

    @Override
    public String unit() {
        return "m";
    }
}
