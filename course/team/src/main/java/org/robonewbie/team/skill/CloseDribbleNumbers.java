package org.robonewbie.team.skill;

import java.util.Arrays;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

/**
 * The numbers of {@link CloseDribble}. CMA-ES has found them in three rounds (walk, touches, both) on 25 November 2026, at commit 020d3efe; the largest
 * speed, its change and the speed of a touch were set by hand after that.
 *
 * @param style the walk
 * @param touchSpeed the speed at which the robot touches a ball that lies still, metres per second
 * @param rollingShare how much faster it may be for each metre per second with which the ball rolls away
 * @param braking how hard the robot counts on braking, metres per second squared
 * @param touchMetres how far ahead of the robot the ball is when a foot touches it
 * @param aheadSeconds for which moment the ball is foreseen, seconds from now
 * @param calmMetres how far the ball may lie aside without a correction
 * @param calmDegrees how far the robot may look aside without a correction
 * @param turn degrees per second that it turns for each degree beyond that
 * @param ballTurn degrees per second that it turns for each degree by which the ball is to its left
 * @param leastSeconds the shortest time in which it corrects how far aside the ball is
 * @param behindMetres how far ahead the ball should be by then
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

    /** The numbers that were found. */
    public static final CloseDribbleNumbers FOUND = of(COORDINATES);

    /**
     * Makes numbers from the coordinates of a search.
     *
     * @param x coordinates of {@link FastWalk}, and one for each number after them; 1 is a noticeable change
     * @return the numbers
     */
    public static CloseDribbleNumbers of(double... x) {
        int i = FastWalk.PARAMETERS;
        WalkVelocity most = new WalkVelocity(0.05 * x[i++], 0.03 * x[i++], 20 * x[i++]);
        WalkVelocity change = new WalkVelocity(0.02 * x[i++], 0.01 * x[i++], 4 * x[i++]);
        return new CloseDribbleNumbers(
                FastWalk.style(Arrays.copyOf(x, FastWalk.PARAMETERS)).within(most, change),
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

    /** The speed from which the robot can still brake before it touches a ball that is so far ahead and rolls away so fast. */
    double speed(double ahead, double rolling) {
        double touch = touchSpeed + rollingShare * rolling;
        double gap = Math.max(0, ahead - touchMetres);
        return Math.sqrt(touch * touch + 2 * braking * gap);
    }

    /** In which time the robot corrects how far aside a ball is, if it walks with so much speed. */
    double seconds(double ahead, double speed) {
        return Math.max(leastSeconds, (ahead - behindMetres) / speed);
    }
}
