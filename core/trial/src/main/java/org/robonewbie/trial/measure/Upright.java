package org.robonewbie.trial.measure;

import org.robonewbie.trial.WorldState;

/** The mean tilt of the torso in degrees. After a fall, the tilt is taken to be 90 degrees. */
public final class Upright extends MeasureFromStart {

    private static final double FALLEN_DEGREES = 90;

    private double sum;
    private long states;

    /** Creates the measure. */
    public Upright() {
        super("degrees of tilt", false);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        sum += hasFallen() ? FALLEN_DEGREES : now.robot().tiltDegrees();
        states++;
    }

    @Override
    public double value() {
        return states > 0 ? sum / states : 0;
    }
}
