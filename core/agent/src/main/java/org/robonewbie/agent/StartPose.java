package org.robonewbie.agent;

/**
 * Where a robot stands on the pitch, in its team's own coordinates: the origin is the centre spot, x points to the opponents'
 * goal and y to the left of that.
 *
 * @param x metres; your half has x ≤ 0
 * @param y metres
 * @param degrees heading; 0 is towards the opponents' goal, positive is left
 */
public record StartPose(double x, double y, double degrees) {

    /** A line-up for numbers 1 to 11 that fits on the small pitch; number 1 keeps the goal. */
    private static final StartPose[] LINE_UP = {
        new StartPose(-5, 0, 0),
        new StartPose(-0.6, 0, 0),
        new StartPose(-1, 2, 0),
        new StartPose(-1, -2, 0),
        new StartPose(-3, 0, 0),
        new StartPose(-3, -1.5, 0),
        new StartPose(-3, 1.5, 0),
        new StartPose(-4, -2, 0),
        new StartPose(-4, 0, 0),
        new StartPose(-4, 2, 0),
        new StartPose(-2, 0, 0)
    };

    /**
     * Returns a place in the usual line-up of a team.
     *
     * @param number the robot's number, 1 to 11
     * @return a place in your half that no other number has
     * @throws IllegalArgumentException if there is no such number
     */
    public static StartPose ofNumber(int number) {
        if (number < 1 || number > LINE_UP.length) {
            throw new IllegalArgumentException("Robots have the numbers 1 to 11, not " + number);
        }
        return LINE_UP[number - 1];
    }
}
