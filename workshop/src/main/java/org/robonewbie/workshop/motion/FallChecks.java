package org.robonewbie.workshop.motion;

import java.util.List;
import java.util.Random;
import java.util.function.LongFunction;
import org.robonewbie.learning.motion.FallenPose;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.MeasureFromStart;

/** Checks of the motions that start or end on the ground. */
final class FallChecks {

    private static final double SHOT_METRES = 2;
    private static final double SHOT_METRES_PER_SECOND = 2;
    private static final double REACTION_SECONDS = 0.1;
    private static final double END_SECONDS = 3;
    private static final double MAX_ASIDE = 0.6;

    private FallChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                fall("fall-forward", FallenPose.ON_FRONT),
                fall("fall-back", FallenPose.ON_BACK),
                rollOver(),
                dive("dive-left", 1),
                dive("dive-right", -1));
    }

    private static MotionCheck fall(String name, FallenPose end) {
        return check(name, "stance", end, seed -> MotionTrial.inStance(seed, 0));
    }

    private static MotionCheck rollOver() {
        String start = "lying on front after a fall, arms in any position";
        return check(
                "roll-over-to-back",
                start,
                FallenPose.ON_BACK,
                seed -> FallenPose.ON_FRONT.fallen(RobotType.TYPE_0, seed));
    }

    private static MotionCheck check(String name, String start, FallenPose end, LongFunction<MotionTrial> opening) {
        return new MotionCheck(name, start, "ends " + end.words(), "s", seed -> {
            try (MotionTrial robot = opening.apply(seed)) {
                robot.allowFalls();
                robot.play(ShippedMotions.motion(name));
                double seconds = robot.seconds();
                robot.hold(1);
                return new Outcome(end.isTrueOf(robot.body()), seconds);
            }
        });
    }

    private static MotionCheck dive(String name, int side) {
        return new MotionCheck(
                name,
                "stance, 0.1 s after a shot at 2 m/s from 2 m away, passing up to 0.6 m to the side",
                "the ball does not get past the robot",
                "m to the side of the ball's path",
                seed -> dive(ShippedMotions.motion(name), side, seed));
    }

    /** Shoots a ball past one side of the robot, which dives a moment later. */
    private static Outcome dive(Motion dive, int side, long seed) {
        Random random = new Random(13 * seed + 5);
        random.nextLong();
        double passesAt = side * MAX_ASIDE * random.nextDouble();
        double from = passesAt + 0.3 * random.nextGaussian();
        try (MotionTrial robot = MotionTrial.inStance(seed, 0)) {
            robot.allowFalls();
            Vector3 start = robot.start().pointAt(SHOT_METRES, from);
            Vector3 way = robot.start().pointAt(0, passesAt).minus(start);
            robot.trial().placeBall(start);
            robot.trial().ball().setVelocity(way.times(SHOT_METRES_PER_SECOND / way.length()));
            robot.hold(REACTION_SECONDS);
            Goal goal = new Goal(robot.start());
            robot.watch(goal);
            robot.play(dive);
            robot.hold(Math.max(0, END_SECONDS - dive.durationMillis() / 1000.0));
            return new Outcome(goal.value() == 0, Math.abs(passesAt));
        }
    }

    /** Measure that is 1 if the ball has passed the robot, otherwise 0. */
    private static final class Goal extends MeasureFromStart {

        private static final double BEHIND = -0.3;

        private final Pose2d place;
        private boolean passed;

        Goal(Pose2d place) {
            this.place = place;
        }

        @Override
        protected void see(WorldState first, WorldState now) {
            passed |= place.ahead(now.ball()) < BEHIND;
        }

        @Override
        public double value() {
            return passed ? 1 : 0;
        }
    }
}
