package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** How much the torso leans in the mean of the trial, in degrees; after a fall 90. */
public final class Upright extends MeasureFromStart {

    private static final double FALLEN_DEGREES = 90;

    private double sum;
    private long moments;

    /** Creates a measure that has not seen anything. */
    public Upright() {}

    @Override
    protected void see(WorldState first, WorldState now) {
        sum += hasFallen() ? FALLEN_DEGREES : now.robot().tiltDegrees();
        moments++;
    }

    @Override
    public double value() {
        return moments > 0 ? sum / moments : 0;
    }

    @Override
    public String unit() {
        return "degrees of tilt";
    }

    @Override
    public boolean isLargerBetter() {
        return false;
    }
}
