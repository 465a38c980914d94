package org.robonewbie.workshop.motion;

import java.util.List;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of the walking motions. */
final class WalkChecks {

    private static final double WAY = 5;
    private static final double MAX_SECONDS = 120;

    private WalkChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                walk(CheckStart.BARE, "walk-forward"),
                straight("walk-forward"),
                walk(CheckStart.BARE, "walk-forward-fast"),
                straight("walk-forward-fast"),
                turn("turn-left", 1),
                turn("turn-right", -1),
                turn("turn-left-small", 1),
                turn("turn-right-small", -1),
                sideStep("side-step-left", 1),
                sideStep("side-step-right", -1),
                onTheSpot("stand"),
                onTheSpot("wave"),
                onTheSpot("bow"),
                onTheSpot("dance"));
    }

    static MotionCheck walk(CheckStart start, String name) {
        return start.check(name, "walks 5 m, stops, ends in the stance", "m/s over the 5 m", (robot, seed) -> {
            walkFiveMetres(robot, name);
            double speed = robot.forward() / robot.seconds();
            robot.play(ShippedMotions.motion("stop-walking"));
            return new Outcome(robot.endsInStance(), speed);
        });
    }

    private static MotionCheck straight(String name) {
        String rule = "turns by at most 10° over 5 m";
        return CheckStart.BARE.check(name + ", straight", rule, "degrees to either side", (robot, seed) -> {
            walkFiveMetres(robot, name);
            double turn = Math.abs(robot.turnedDegrees());
            return new Outcome(!robot.balance().hasFallen() && turn <= 10, turn);
        });
    }

    private static void walkFiveMetres(MotionTrial robot, String name) {
        robot.play(ShippedMotions.motion("start-walking"));
        Motion walk = ShippedMotions.motion(name);
        while (robot.forward() < WAY && robot.seconds() < MAX_SECONDS && robot.play(walk)) {
            // consecutive cycles of two steps
        }
    }

    private static MotionCheck turn(String name, int sign) {
        String rule = "turns once around, ends in the stance";
        return CheckStart.BARE.check(name, rule, "degrees each time", (robot, seed) -> {
            Motion turn = ShippedMotions.motion(name);
            int times = 0;
            while (sign * robot.turnedDegrees() < 360 && robot.seconds() < MAX_SECONDS && robot.play(turn)) {
                times++;
            }
            return new Outcome(robot.endsInStance(), Math.abs(robot.turnedDegrees()) / Math.max(1, times));
        });
    }

    private static MotionCheck sideStep(String name, int sign) {
        return CheckStart.BARE.check(name, "ends in the stance after five times", "m each time", (robot, seed) -> {
            playFiveTimes(robot, name);
            double metres = sign * robot.left() / 5;
            return new Outcome(robot.endsInStance() && metres > 0, metres);
        });
    }

    private static MotionCheck onTheSpot(String name) {
        return CheckStart.BARE.check(name, "ends in the stance after five times", "s each time", (robot, seed) -> {
            playFiveTimes(robot, name);
            double seconds = robot.seconds() / 5;
            return new Outcome(robot.endsInStance(), seconds);
        });
    }

    private static void playFiveTimes(MotionTrial robot, String name) {
        for (int i = 0; i < 5; i++) {
            robot.play(ShippedMotions.motion(name));
        }
    }
}
