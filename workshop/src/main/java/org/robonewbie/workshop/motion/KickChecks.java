package org.robonewbie.workshop.motion;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.KickDistance;
import org.robonewbie.trial.measure.MeasureFromStart;

/** Checks of kicks and passes. */
final class KickChecks {

    private static final double STRONG_METRES = 4;
    private static final double FAR_METRES = 8;
    private static final double FAR_SECONDS = 2;
    private static final double STRAIGHT_DEGREES = 5;
    private static final double QUICK_METRES = 3;
    private static final double QUICK_SECONDS = 0.8;
    private static final double ROLLING_METRES_PER_SECOND = 1;
    private static final double MIN_PASS_METRES = 1;
    private static final double MAX_PASS_METRES = 2;
    private static final double MAX_ROLLING_SECONDS = 15;
    private static final double AT_REST = 0.02;

    private KickChecks() {}

    static List<MotionCheck> all(RobotType type) {
        CheckStart start = CheckStart.kicker(type);
        return Stream.of("left", "right")
                .flatMap(side -> Stream.of(
                        kick(start, "kick-" + side),
                        pass(start, "pass-" + side),
                        quickKick(start, "quick-kick-" + side),
                        soon(start, "quick-kick-" + side, QUICK_SECONDS),
                        farKick(start, "far-kick-" + side),
                        straight(start, "far-kick-" + side),
                        soon(start, "far-kick-" + side, FAR_SECONDS)))
                .toList();
    }

    static MotionCheck kick(CheckStart start, String name) {
        return kick(start, name, "the ball rolls at least 4 m, the robot ends in the stance", STRONG_METRES, 99);
    }

    static MotionCheck pass(CheckStart start, String name) {
        String rule = "the ball rolls 1 to 2 m, the robot ends in the stance";
        return kick(start, name, rule, MIN_PASS_METRES, MAX_PASS_METRES);
    }

    private static MotionCheck quickKick(CheckStart start, String name) {
        return kick(start, name, "the ball rolls at least 3 m, the robot ends in the stance", QUICK_METRES, 99);
    }

    static MotionCheck farKick(CheckStart start, String name) {
        return kick(start, name, "the ball rolls at least 8 m, the robot ends in the stance", FAR_METRES, 99);
    }

    private static MotionCheck straight(CheckStart start, String name) {
        String rule = "the ball rolls at least 8 m, within 5° of the robot's heading";
        return start.check(name + ", straight", rule, "degrees to either side", (robot, seed) -> {
            Kick kick = kick(robot, ShippedMotions.file(name), seed);
            double degrees = Math.abs(kick.degreesAside());
            return new Outcome(kick.metres() >= FAR_METRES && degrees <= STRAIGHT_DEGREES, degrees);
        });
    }

    private static MotionCheck soon(CheckStart start, String name, double mostSeconds) {
        String rule = "the ball is faster than 1 m/s after at most " + mostSeconds + " s";
        return start.check(name + ", soon", rule, "s until the ball is faster than 1 m/s", (robot, seed) -> {
            MotionFile file = ShippedMotions.file(name);
            robot.placeBall(file.ball().orElseThrow(), seed);
            FirstRoll roll = new FirstRoll();
            robot.watch(roll);
            robot.play(file.motion());
            return new Outcome(roll.value() <= mostSeconds, roll.value());
        });
    }

    private static MotionCheck kick(CheckStart start, String name, String rule, double least, double most) {
        return start.check(name, rule, "m", (robot, seed) -> {
            Kick kick = kick(robot, ShippedMotions.file(name), seed);
            boolean far = kick.metres() >= least && kick.metres() <= most;
            return new Outcome(far && kick.standing(), kick.metres());
        });
    }

    /** Kicks and waits until the ball is at rest. */
    private static Kick kick(MotionTrial robot, MotionFile file, long seed) {
        robot.placeBall(file.ball().orElseThrow(), seed);
        Vector3 from = robot.trial().now().ball();
        robot.play(file.motion());
        boolean standing = robot.endsInStance();
        for (int i = 0;
                i < MAX_ROLLING_SECONDS && robot.trial().now().ballVelocity().length() > AT_REST;
                i++) {
            robot.hold(1);
        }
        Vector3 to = KickDistance.restingPlace(robot.trial().now());
        double ahead = robot.start().ahead(to) - robot.start().ahead(from);
        double aside = robot.start().left(to) - robot.start().left(from);
        return new Kick(ahead, Math.toDegrees(Math.atan2(aside, Math.max(1e-3, ahead))), standing);
    }

    /**
     * Result of a kick.
     *
     * @param metres distance that the ball travels along the robot's heading
     * @param degreesAside direction of the ball relative to the robot's heading, positive to the left
     * @param standing whether the robot ends in its standard stance
     */
    private record Kick(double metres, double degreesAside, boolean standing) {}

    /** Measure of the time in seconds from the start of the kick until the ball is faster than 1 m/s. */
    private static final class FirstRoll extends MeasureFromStart {

        private double seconds = Double.POSITIVE_INFINITY;

        @Override
        protected void see(WorldState first, WorldState now) {
            if (now.ballVelocity().length() > ROLLING_METRES_PER_SECOND) {
                seconds = Math.min(seconds, now.seconds() - first.seconds());
            }
        }

        @Override
        public double value() {
            return seconds;
        }
    }
}
