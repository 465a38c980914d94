package org.robonewbie.learning.rehearsal;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * How somebody who walks keeps to a line: who is beside it heads for it, and turns the faster the more the heading is wrong.
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
public record LineKeeping(double degreesForAMetre, double mostDegrees, double turnForADegree, double mostTurn) {

    /** For a run that hardly bears a bend. */
    public static final LineKeeping GENTLE = new LineKeeping(20, 10, 1, 10);

    /** For who bends easily. */
    public static final LineKeeping FIRM = new LineKeeping(40, 10, 2, 40);

    /**
     * Steers.
     *
     * @param line where the line begins, and its heading
     * @param now where the robot is
     * @return how fast to turn, degrees per second to the left
     */
    public double turn(Pose2d line, Pose2d now) {
        double left = line.fromFrame(new Vector3(now.x(), now.y(), 0)).y();
        double heading = line.degrees() - within(mostDegrees, degreesForAMetre * left);
        return within(mostTurn, turnForADegree * Angles.wrap(heading - now.degrees()));
    }

    private static double within(double most, double value) {
        return Math.max(-most, Math.min(most, value));
    }
}
