package org.robonewbie.trial.measure;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.trial.WorldState;

/**
 * How far the ball gets, in a straight line, from the place where it left the robot, in metres. It has left the robot when it is
 * farther than 0.35 m from the torso, so a ball that is pushed along gains nothing. Decided when the referee takes the ball.
 */
public final class LongestKick extends MeasureFromStart {

    private static final double AT_ROBOT_METRES = 0.35;

    private Vector3 left = Vector3.ZERO;
    private double metres;
    private boolean taken;

    /** Creates a measure that has not seen anything. */
    public LongestKick() {}

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

    /** Once the ball is out or in the goal, the referee carries it away. */
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
    public String unit() {
        return "m";
    }

    @Override
    public boolean isDecided() {
        return taken;
    }
}
