package org.robonewbie.trial.measure;

import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.trial.WorldState;

/** How far the robot has turned to the left, in degrees, whole turns included. */
public final class Turn extends MeasureFromStart {

    private double degrees;
    private double lastHeading = Double.NaN;

    /** Creates a measure that has not seen anything. */
    public Turn() {}

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

    @Override
    public String unit() {
        return "degrees";
    }
}
