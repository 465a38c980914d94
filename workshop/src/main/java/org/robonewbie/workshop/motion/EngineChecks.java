package org.robonewbie.workshop.motion;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.ErraticVelocities;
import org.robonewbie.learning.motion.MotionTrial;

/** Checks of the walk engine. */
final class EngineChecks {

    private static final WalkStyle STYLE = WalkStyle.STANDARD;
    private static final WalkVelocity AHEAD = new WalkVelocity(STYLE.most().forward(), 0, 0);
    private static final WalkVelocity BACK = new WalkVelocity(-STYLE.backward(), 0, 0);
    private static final WalkVelocity LEFT = new WalkVelocity(0, STYLE.most().left(), 0);
    private static final WalkVelocity RIGHT = new WalkVelocity(0, -STYLE.most().left(), 0);
    private static final WalkVelocity TURN = new WalkVelocity(0, 0, STYLE.most().turn());

    private EngineChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                forward(CheckStart.BARE),
                straight(),
                way(CheckStart.BARE, "walk engine, backward", BACK, 2, robot -> -robot.forward()),
                way(CheckStart.BARE, "walk engine, to the left", LEFT, 2, MotionTrial::left),
                way(CheckStart.BARE, "walk engine, to the right", RIGHT, 2, robot -> -robot.left()),
                turn(CheckStart.BARE),
                erratic());
    }

    static MotionCheck forward(CheckStart start) {
        return way(start, "walk engine, forward", AHEAD, 5, MotionTrial::forward);
    }

    private static MotionCheck way(
            CheckStart start, String name, WalkVelocity velocity, double metres, ToDoubleFunction<MotionTrial> way) {
        String rule = "walks " + Math.round(metres) + " m, stops, ends in the stance";
        return start.check(name, rule, "m/s on average", (robot, seed) -> {
            robot.walk(() -> velocity, () -> way.applyAsDouble(robot) < metres);
            double speed = way.applyAsDouble(robot) / robot.seconds();
            return new Outcome(robot.stopWalking() && robot.endsInStance() && speed > 0, speed);
        });
    }

    private static MotionCheck straight() {
        String rule = "turns by at most 10° over 5 m";
        return CheckStart.BARE.check("walk engine, straight", rule, "degrees to either side", (robot, seed) -> {
            boolean up = robot.walk(() -> AHEAD, () -> robot.forward() < 5);
            double turn = Math.abs(robot.turnedDegrees());
            return new Outcome(up && turn <= 10, turn);
        });
    }

    static MotionCheck turn(CheckStart start) {
        return start.check("walk engine, turn", "turns once around, ends in the stance", "°/s", (robot, seed) -> {
            robot.walk(() -> TURN, () -> robot.turnedDegrees() < 360);
            double speed = robot.turnedDegrees() / robot.seconds();
            return new Outcome(robot.stopWalking() && robot.endsInStance(), speed);
        });
    }

    private static MotionCheck erratic() {
        return new MotionCheck(
                "walk engine, erratic",
                "stance, reached from a nearby posture",
                "stands after 30 s of random velocities, a new one every 0.7 s on average",
                "s on its feet",
                seed -> {
                    try (MotionTrial robot = MotionTrial.inStance(seed, 3)) {
                        robot.walk(new ErraticVelocities(STYLE, seed), () -> robot.seconds() < 30);
                        double seconds = robot.seconds();
                        return new Outcome(robot.stopWalking() && robot.endsInStance(), seconds);
                    }
                });
    }
}
