package org.robonewbie.trial.measure;

import org.robonewbie.nao.Vector3;
import org.robonewbie.trial.WorldState;

/**
 * The distance that the ball covers along the robot's initial heading, in metres, including the estimated distance that it
 * has yet to roll.
 */
public final class KickDistance extends MeasureFromStart {

    /** Rolling distance in metres for each metre per second of the ball's speed, as measured in trials. */
    private static final double ROLL_OUT_SECONDS = 0.94;

    private double metres;

    /** Creates the measure. */
    public KickDistance() {
        super("m", true);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        metres = first.place().ahead(restingPlace(now)) - first.place().ahead(first.ball());
    }

    /**
     * Estimates where a rolling ball comes to rest.
     *
     * @param state the current state
     * @return the resting point, at the current height of the ball
     */
    public static Vector3 restingPlace(WorldState state) {
        return state.ball().plus(state.ballVelocity().times(ROLL_OUT_SECONDS));
    }

    @Override
    public double value() {
        return metres;
    }
}
