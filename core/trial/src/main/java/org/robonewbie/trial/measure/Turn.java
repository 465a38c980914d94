package org.robonewbie.trial.measure;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.trial.WorldState;

/** The accumulated rotation of the robot to the left, in degrees. */
public final class Turn extends MeasureFromStart {

    private double degrees;
    private double lastHeading = Double.NaN;

    /** Creates the measure. */
    public Turn() {
        super("degrees", true);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        double heading = now.robot().headingDegrees();
        degrees += Double.isNaN(lastHeading) ? 0 : Angles.wrap(heading - lastHeading);
        lastHeading = heading;
    }

    @Override
    public double value() {
        return degrees;
    }
}
