package org.robonewbie.learning.trial;

import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.Motion;

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

    private static final double BALL_RADIUS = 0.042;
    private static final double PUSH_NEWTONS = 2;
    private static final double MOST_SECONDS = 15;
    private static final double AT_REST = 0.02;

    /** A rolling ball comes this much further for each metre per second, as trials show. */
    private static final double ROLLS_ON_SECONDS = 0.94;

    /**
     * Carries out a trial until the ball lies still.
     *
     * @param kick the motion
     * @param ball where the ball should lie
     * @param seed chooses the ball's place and the disturbances
     * @return what happened
     */
    public static KickTrial run(Motion kick, BallPlace ball, long seed) {
        return run(kick, ball, seed, MOST_SECONDS);
    }

    /**
     * Runs a trial until the robot has come to rest, and estimates how far the ball rolls on.
     *
     * @param kick the motion
     * @param ball the nominal place of the ball
     * @param seed chooses the ball's place and the disturbances
     * @return the outcome
     */
    public static KickTrial quick(Motion kick, BallPlace ball, long seed) {
        return run(kick, ball, seed, 0);
    }

    private static KickTrial run(Motion kick, BallPlace ball, long seed, double secondsToRoll) {
        Course course = new Course(seed, PUSH_NEWTONS);
        TrialRobot robot = course.robot();
        Random random = new Random(7 * seed + 3);
        random.nextLong();
        BallPlace place = ball.near(random);
        Vector3 start = course.place(place.ahead(), place.left(), BALL_RADIUS);
        robot.ball().place(start);
        course.play(kick);
        double seconds = course.watch().seconds();
        boolean standing = course.endsInStance();
        double planned = kick.durationMillis() / 1000.0;
        for (int i = 0; i < secondsToRoll && robot.ball().velocity().length() > AT_REST; i++) {
            robot.hold(1, TrialObserver.NONE);
        }
        Vector3 end = robot.ball().position().plus(robot.ball().velocity().times(ROLLS_ON_SECONDS));
        Vector3 way = course.seen(end).minus(course.seen(start));
        return new KickTrial(
                way.x(),
                Math.toDegrees(Math.atan2(way.y(), Math.max(1e-3, way.x()))),
                standing,
                standing ? 0 : 1 - Math.min(1, seconds / planned),
                planned);
    }
}
