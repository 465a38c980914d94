package org.robonewbie.learning.rehearsal;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.measure.KickDistance;

/**
 * A kick against a ball that lies up to 1 cm away from its place along each axis.
 *
 * @param metres distance that the ball rolls along the robot's heading
 * @param degreesAside direction in which it rolls, positive to the left
 * @param standing whether the robot ends in the stance
 * @param fallCost 0 if it stands, up to 1 the earlier it falls
 * @param seconds time of the motion
 */
public record KickTrial(double metres, double degreesAside, boolean standing, double fallCost, double seconds) {

    private static final double PUSH_NEWTONS = 2;
    private static final double MOST_SECONDS = 15;
    private static final double AT_REST = 0.02;

    /**
     * Runs a trial until the robot has come to rest, and estimates how far the ball rolls on.
     *
     * @param kick the motion
     * @param ball the nominal place of the ball
     * @param seed chooses the ball's place and the disturbances
     * @return the outcome
     */
    public static KickTrial quick(Motion kick, BallPlace ball, long seed) {
        return quick(RobotType.TYPE_0, kick, ball, seed);
    }

    /**
     * Runs a trial with a robot of some build until it has come to rest, and estimates how far the ball rolls on.
     *
     * @param type how the robot is built
     * @param kick the motion
     * @param ball the nominal place of the ball
     * @param seed chooses the ball's place and the disturbances
     * @return the outcome
     */
    public static KickTrial quick(RobotType type, Motion kick, BallPlace ball, long seed) {
        try (Rehearsal robot = Rehearsal.inStance(type, seed, PUSH_NEWTONS)) {
            return kicked(robot, kick, ball, seed, 0);
        }
    }

    /**
     * Runs a trial until the ball lies still.
     *
     * @param robot a robot in the stance
     * @param kick the motion
     * @param ball the nominal place of the ball
     * @param seed chooses the ball's place
     * @return the outcome
     */
    public static KickTrial toTheEnd(Rehearsal robot, Motion kick, BallPlace ball, long seed) {
        return kicked(robot, kick, ball, seed, MOST_SECONDS);
    }

    private static KickTrial kicked(Rehearsal robot, Motion kick, BallPlace ball, long seed, double secondsToRoll) {
        robot.placeBall(ball, seed);
        Vector3 from = robot.now().ball();
        robot.play(kick);
        double seconds = robot.seconds();
        boolean standing = robot.endsInStance();
        double planned = kick.durationMillis() / 1000.0;
        for (int i = 0; i < secondsToRoll && robot.now().ballVelocity().length() > AT_REST; i++) {
            robot.hold(1);
        }
        Vector3 to = KickDistance.restingPlace(robot.now());
        double ahead = robot.start().ahead(to) - robot.start().ahead(from);
        double aside = robot.start().left(to) - robot.start().left(from);
        return new KickTrial(
                ahead,
                Math.toDegrees(Math.atan2(aside, Math.max(1e-3, ahead))),
                standing,
                standing ? 0 : 1 - Math.min(1, seconds / planned),
                planned);
    }
}
