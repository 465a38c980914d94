package org.robonewbie.learning.trial;

import java.util.List;
import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.Motion;

/**
 * A ball is shot at 2 m/s from 2 m away, to pass the robot at up to 0.6 m on one side; a moment after the shot the robot dives.
 *
 * @param blocked whether the ball never got behind the robot
 * @param passesAt where the ball would pass, metres to the side
 * @param reachInTime how far to the side the robot reaches near the ground when the ball arrives, metres
 * @param jointsAtLimit mean number of joints at their speed limit
 */
public record DiveTrial(boolean blocked, double passesAt, double reachInTime, double jointsAtLimit) {

    private static final double DISTANCE = 2;
    private static final double SPEED = 2;
    private static final double REACTION_SECONDS = 0.1;
    private static final double ARRIVAL_SECONDS = 1.2;
    private static final double END_SECONDS = 3;
    private static final double WIDEST = 0.6;
    private static final double BEHIND = -0.3;
    private static final double LOW = 0.084;
    private static final List<String> BLOCKERS = List.of("head", "body", "llowerarm", "rlowerarm", "lfoot", "rfoot");

    /**
     * Carries out a trial.
     *
     * @param dive the motion
     * @param seed chooses where the ball passes and the disturbances
     * @param side 1 for balls to the left of the robot, -1 to the right
     * @return what happened
     */
    public static DiveTrial run(Motion dive, long seed, int side) {
        Random random = new Random(13 * seed + 5);
        random.nextLong();
        double passesAt = side * WIDEST * random.nextDouble();
        double from = passesAt + 0.3 * random.nextGaussian();
        Course course = new Course(seed, 0);
        TrialRobot robot = course.robot();
        shoot(course, from, passesAt);
        robot.hold(REACTION_SECONDS, TrialObserver.NONE);
        Goal goal = new Goal(course, side);
        robot.play(dive, goal);
        robot.hold(Math.max(0, END_SECONDS - dive.durationMillis() / 1000.0), goal);
        return new DiveTrial(!goal.passed, passesAt, goal.reach, goal.watch.meanJointsAtLimit());
    }

    private static void shoot(Course course, double from, double to) {
        Vector3 start = course.place(DISTANCE, from, 0.042);
        Vector3 way = course.place(0, to, 0.042).minus(start);
        course.robot().ball().place(start);
        course.robot().ball().setVelocity(way.times(SPEED / way.length()));
    }

    /** Observes whether the ball passes the robot, and how far the robot reaches when the ball arrives. */
    private static final class Goal implements TrialObserver {

        private final Course course;
        private final int side;
        private final Watch watch = new Watch();
        private final double start;
        private boolean passed;
        private double reach;

        Goal(Course course, int side) {
            this.course = course;
            this.side = side;
            this.start = course.robot().seconds();
        }

        @Override
        public boolean goOn(TrialRobot robot) {
            watch.goOn(robot);
            passed |= course.seen(robot.ball().position()).x() < BEHIND;
            double seconds = robot.seconds() - start + REACTION_SECONDS;
            if (Math.abs(seconds - ARRIVAL_SECONDS) < 0.011) {
                for (String link : BLOCKERS) {
                    Vector3 place = course.seen(robot.link(link).position());
                    if (robot.link(link).position().z() < 2 * LOW) {
                        reach = Math.max(reach, Math.min(0.7, side * place.y()));
                    }
                }
            }
            return true;
        }
    }
}
