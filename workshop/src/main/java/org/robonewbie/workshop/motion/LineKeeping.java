package org.robonewbie.workshop.motion;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * Controller that keeps a walking robot on a line: cross-track and heading errors each contribute proportionally, with limits.
 *
 * <pre>{@code
 * walk.towards(1, 0, LineKeeping.FIRM.turn(start, self.pose()));
 * }</pre>
 *
 * @param degreesForAMetre desired heading change per metre of cross-track error
 * @param mostDegrees maximum heading change in degrees
 * @param turnForADegree turn rate in degrees per second for each degree of heading error
 * @param mostTurn maximum turn rate in degrees per second
 */
record LineKeeping(double degreesForAMetre, double mostDegrees, double turnForADegree, double mostTurn) {

    /** Parameters for a run that tolerates little turning. */
    static final LineKeeping GENTLE = new LineKeeping(20, 10, 1, 10);

    /** Parameters for the learned sprint, whose command is the heading error itself. */
    static final LineKeeping SPRINT = new LineKeeping(20, 10, 1, 30);

    /** Parameters for a gait that turns easily. */
    static final LineKeeping FIRM = new LineKeeping(40, 10, 2, 40);

    /**
     * Returns the turn rate.
     *
     * @param line start and heading of the line
     * @param now pose of the robot
     * @return degrees per second to the left
     */
    double turn(Pose2d line, Pose2d now) {
        double left = line.fromFrame(new Vector3(now.x(), now.y(), 0)).y();
        double heading = line.degrees() - within(mostDegrees, degreesForAMetre * left);
        return within(mostTurn, turnForADegree * Angles.wrap(heading - now.degrees()));
    }

    private static double within(double most, double value) {
        return Math.max(-most, Math.min(most, value));
    }
}
