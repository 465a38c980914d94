package org.robonewbie.trial.measure;

import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.WorldState;

/** How far the ball gets along the robot's first heading, in metres; what it will still roll counts. */
public final class KickDistance extends MeasureFromStart {

    /** A rolling ball comes this much further for each metre per second, as trials show. */
    private static final double ROLLS_ON_SECONDS = 0.94;

    private double metres;

    /** Creates a measure that has not seen anything. */
    public KickDistance() {}

    @Override
    protected void see(WorldState first, WorldState now) {
        metres = first.place().ahead(restingPlace(now)) - first.place().ahead(first.ball());
    }

    /**
     * Estimates where a rolling ball comes to rest.
     *
     * @param state the ball at some time
     * @return a point as high above the ground as the ball
     */
    public static Vector3 restingPlace(WorldState state) {
        return state.ball().plus(state.ballVelocity().times(ROLLS_ON_SECONDS));
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
