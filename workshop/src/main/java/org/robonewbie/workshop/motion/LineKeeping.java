package org.robonewbie.workshop.motion;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * A controller that keeps a walking robot on a line: it heads for the line, and turns the faster the more the heading is wrong.
 *
 * <pre>{@code
 * walk.towards(1, 0, LineKeeping.FIRM.turn(start, self.pose()));
 * }</pre>
 *
 * @param degreesForAMetre how much the heading changes for each metre beside the line
 * @param mostDegrees how much it changes at most
 * @param turnForADegree degrees per second for each degree by which the heading is wrong
 * @param mostTurn how fast it turns at most, degrees per second
 */
record LineKeeping(double degreesForAMetre, double mostDegrees, double turnForADegree, double mostTurn) {

    /** For a run that hardly bears a turn. */
    static final LineKeeping GENTLE = new LineKeeping(20, 10, 1, 10);

    /** For a gait that turns easily. */
    static final LineKeeping FIRM = new LineKeeping(40, 10, 2, 40);

    /**
     * Steers.
     *
     * @param line where the line begins, and its heading
     * @param now where the robot is
     * @return how fast to turn, degrees per second to the left
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
