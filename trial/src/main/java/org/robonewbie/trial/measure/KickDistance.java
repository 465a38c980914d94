package org.robonewbie.trial.measure;

import org.robonewbie.trial.Moment;

/** How far the ball gets along the robot's first heading, in metres; what it will still roll counts. */
public final class KickDistance extends MeasureFromStart {

    /** A rolling ball comes this much further for each metre per second, as trials show. */
    private static final double ROLLS_ON_SECONDS = 0.94;

    private double metres;

    /** Creates a measure that has not seen anything. */
    public KickDistance() {}

    @Override
    protected void see(Moment first, Moment now) {
        metres = first.place().ahead(now.ball().plus(now.ballVelocity().times(ROLLS_ON_SECONDS)))
                - first.place().ahead(first.ball());
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
