package org.robonewbie.learning.trial;

import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;

/**
 * A kick against a ball that lies before the foot, somewhere within 4 cm along and 3 cm across.
 *
 * @param metres how far the ball rolls along the robot's heading
 * @param degreesAside direction in which it rolls, positive to the left
 * @param standing whether the robot ends in the stance
 * @param fallCost 0 if it stands, up to 1 the earlier it falls
 * @param seconds time of the motion
 */
public record KickTrial(double metres, double degreesAside, boolean standing, double fallCost, double seconds) {

    private static final double BALL_AHEAD = 0.19;
    private static final double BALL_RADIUS = 0.042;
    private static final double PUSH_NEWTONS = 2;
    private static final double MOST_SECONDS = 15;
    private static final double AT_REST = 0.02;

    /**
     * Carries out a trial until the ball lies still.
     *
     * @param kick the motion
     * @param seed chooses the ball's place and the disturbances
     * @param ballLeft where the ball lies in the mean, metres to the left of the torso
     * @return what happened
     */
    public static KickTrial run(Motion kick, long seed, double ballLeft) {
        Course course = new Course(seed, PUSH_NEWTONS);
        TrialRobot robot = course.robot();
        Random random = new Random(7 * seed + 3);
        random.nextLong();
        double ahead = BALL_AHEAD + 0.02 * (2 * random.nextDouble() - 1);
        double left = ballLeft + 0.015 * (2 * random.nextDouble() - 1);
        Vector3 start = course.place(ahead, left, BALL_RADIUS);
        robot.ball().place(start);
        course.play(kick);
        double seconds = course.watch().seconds();
        boolean standing = course.endsInStance();
        double planned = kick.durationMillis() / 1000.0;
        for (int i = 0; i < MOST_SECONDS && robot.ball().velocity().length() > AT_REST; i++) {
            robot.hold(1, TrialObserver.NONE);
        }
        Vector3 way = course.seen(robot.ball().position()).minus(course.seen(start));
        return new KickTrial(
                way.x(),
                Math.toDegrees(Math.atan2(way.y(), Math.max(1e-3, way.x()))),
                standing,
                standing ? 0 : 1 - Math.min(1, seconds / planned),
                planned);
    }
}
