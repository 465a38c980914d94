package org.robonewbie.team.skill;

import java.util.Arrays;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

/**
 * Parameters of {@link CloseDribble}. They were found by CMA-ES in three rounds (walk, touches, both) on 25 November 2026, at
 * commit 020d3efe; the limits on the speed and on its changes, and the touch speed, were then set by hand.
 *
 * @param style walking style
 * @param touchSpeed speed at which the robot touches a resting ball, in metres per second
 * @param rollingShare additional speed for each metre per second at which the ball is rolling away
 * @param braking assumed deceleration of the robot, in metres per second squared
 * @param touchMetres distance in metres from robot to ball, along the path, when a foot touches the ball
 * @param aheadSeconds prediction time for the ball in seconds
 * @param calmMetres dead band of the lateral correction in metres
 * @param calmDegrees dead band of the heading correction in degrees
 * @param turn turn rate per degree of heading error
 * @param ballTurn turn rate per degree of the ball's bearing to the left
 * @param leastSeconds minimum time for a lateral correction in seconds
 * @param behindMetres distance in metres from robot to ball, along the path, at which the lateral correction should be complete
 */
public record CloseDribbleNumbers(
        WalkStyle style,
        double touchSpeed,
        double rollingShare,
        double braking,
        double touchMetres,
        double aheadSeconds,
        double calmMetres,
        double calmDegrees,
        double turn,
        double ballTurn,
        double leastSeconds,
        double behindMetres) {

    private static final double[] COORDINATES = {
        1.988, -0.047, 2.032, -2.327, 2.724, 0.606, -2.134, 0.851, -0.060, -0.039, -2.587, 0.072, -5.720, 1.486, 0.067,
        0.958, -2.330, -0.644, 0.785, 0.262, -0.636, 2.892, 0.904, 1.889, -2.363, 3.194, 6.273, 3.532, 0.343, 0.850,
        -0.556, 3.887, -1.148, 1.176, 4.717, 1.906, -2.358, -1.097, 17.000, 6.270, 4.770, 8.500, 8.418, 5.323, 6.000,
        3.643, 3.554, 9.091, 4.551, 2.993, 2.955, 3.528, -1.110, 4.366, 6.770
    };

    /** The parameters found by the search. */
    public static final CloseDribbleNumbers FOUND = of(COORDINATES);

    /**
     * Creates parameters from the coordinates of a search.
     *
     * @param x coordinates of {@link FastWalk}, then one for each further parameter; a change of 1 is noticeable
     * @return the parameters
     */
    public static CloseDribbleNumbers of(double... x) {
        int i = FastWalk.PARAMETERS;
        WalkVelocity most = new WalkVelocity(0.05 * x[i++], 0.03 * x[i++], 20 * x[i++]);
        WalkVelocity change = new WalkVelocity(0.02 * x[i++], 0.01 * x[i++], 4 * x[i++]);
        WalkStyle fast = FastWalk.style(Arrays.copyOf(x, FastWalk.PARAMETERS));
        return new CloseDribbleNumbers(
                fast.withLimits(most, Math.min(fast.backward(), most.forward()), change),
                0.05 * x[i++],
                0.1 * x[i++],
                0.1 * x[i++],
                0.02 * x[i++],
                0.05 * x[i++],
                0.005 * x[i++],
                x[i++],
                0.3 * x[i++],
                0.2 * x[i++],
                0.1 * x[i++],
                0.03 * x[i]);
    }

    /**
     * Returns the maximum speed from which the robot can brake before it touches a ball at a given distance and rolling speed.
     */
    double speed(double ahead, double rolling) {
        double touch = touchSpeed + rollingShare * rolling;
        double gap = Math.max(0, ahead - touchMetres);
        return Math.sqrt(touch * touch + 2 * braking * gap);
    }

    /** Returns the time in seconds for a lateral correction, given the distance to the ball and the speed of the robot. */
    double seconds(double ahead, double speed) {
        return Math.max(leastSeconds, (ahead - behindMetres) / speed);
    }
}
