package org.robonewbie.trial.measure;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.WorldState;

/**
 * The maximum straight-line distance, in metres, between the ball and the point where it left the robot. The ball has left the
 * robot once it is more than 0.35 m from the torso, so dribbling does not count. The measure is decided when the referee moves
 * the ball.
 */
public final class LongestKick extends MeasureFromStart {

    private static final double AT_ROBOT_METRES = 0.35;

    private Vector3 left = Vector3.ZERO;
    private double metres;
    private boolean taken;

    /** Creates the measure. */
    public LongestKick() {
        super("m", true);
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        left = now.seconds() > first.seconds() ? left : first.ball();
        taken |= isTakenByReferee(now);
        Vector3 ball = now.ball();
        if (now.place().distance(ball) < AT_ROBOT_METRES) {
            left = ball;
        } else if (!taken) {
            metres = Math.max(metres, PortableMath.hypot(ball.x() - left.x(), ball.y() - left.y()));
        }
    }

    /** Returns whether the referee removes the ball because it has left the pitch or entered a goal. */
    private static boolean isTakenByReferee(WorldState state) {
        return switch (state.playMode()) {
            case PLAY_ON, KICK_OFF_LEFT, KICK_OFF_RIGHT -> false;
            default -> true;
        };
    }

    @Override
    public double value() {
        return metres;
    }

    @Override
    public boolean isDecided() {
        return taken;
    }
}
