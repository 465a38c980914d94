package org.robonewbie.learning.rehearsal;

import java.util.List;
import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.MeasureFromStart;

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
        try (Rehearsal robot = Rehearsal.inStance(seed, 0)) {
            robot.allowFalls();
            Vector3 start = robot.start().pointAt(DISTANCE, from);
            Vector3 way = robot.start().pointAt(0, passesAt).minus(start);
            robot.shoot(start, way.times(SPEED / way.length()));
            robot.hold(REACTION_SECONDS);
            Goal goal = new Goal(robot.start(), side);
            robot.watch(goal);
            robot.play(dive);
            robot.hold(Math.max(0, END_SECONDS - dive.durationMillis() / 1000.0));
            return new DiveTrial(
                    !goal.passed, passesAt, goal.value(), robot.poise().meanJointsAtLimit());
        }
    }

    /** Sees whether the ball passes the robot, and how far the robot reaches when the ball arrives. */
    private static final class Goal extends MeasureFromStart {

        private final Pose2d place;
        private final int side;
        private boolean passed;
        private double reach;

        Goal(Pose2d place, int side) {
            this.place = place;
            this.side = side;
        }

        @Override
        protected void see(WorldState first, WorldState now) {
            passed |= place.ahead(now.ball()) < BEHIND;
            double seconds = now.seconds() - first.seconds() + REACTION_SECONDS;
            if (Math.abs(seconds - ARRIVAL_SECONDS) < 0.011) {
                BodyPoses limbs = now.robot().limbs();
                for (String link : BLOCKERS) {
                    Vector3 part = limbs.link(link).position();
                    if (part.z() < 2 * LOW) {
                        reach = Math.max(reach, Math.min(0.7, side * place.left(part)));
                    }
                }
            }
        }

        @Override
        public double value() {
            return reach;
        }
    }
}
