package org.robonewbie.learning.measure;

import java.util.List;
import java.util.Random;
import java.util.function.BiFunction;
import org.robonewbie.agent.walk.Walk;
import org.robonewbie.learning.trial.ServedRobot;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** The most important checks once more, with an agent on a whole simulator instead of a robot in a bare world. */
final class ServerChecks {

    private static final String SERVER = ", on the server";
    private static final String START = "an agent on an own simulator with noise, in the stance";
    private static final double WAY = 5;
    private static final double BALL_RADIUS = 0.042;

    private ServerChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                walk("walk-forward"),
                walk("walk-forward-fast"),
                engine(),
                turn(),
                getUp("stand-up-from-back", "fall-back"),
                getUp("stand-up-from-front", "fall-forward"),
                kick("kick-right", 4, 99, "the ball rolls at least 4 m"),
                kick("pass-right", 1, 2, "the ball rolls 1 to 2 m"));
    }

    private static MotionCheck walk(String name) {
        return check(name, "walks 5 m, stops, stands", "m/s over the 5 m", (robot, seed) -> {
            while (robot.forward() < WAY && robot.seconds() < 60) {
                robot.perform(name);
            }
            double speed = robot.forward() / robot.seconds();
            robot.perform("stop-walking");
            return new Outcome(robot.endsStanding(), speed);
        });
    }

    private static MotionCheck engine() {
        return check("walk engine, forward", "walks 5 m, stops, stands", "m/s over the 5 m", (robot, seed) -> {
            double seconds = robot.walk(Walk.MOST_FORWARD, 0, 0, () -> robot.forward() >= WAY);
            return new Outcome(robot.endsStanding(), WAY / seconds);
        });
    }

    private static MotionCheck turn() {
        return check("walk engine, turn", "turns once around, stands", "°/s", (robot, seed) -> {
            double seconds = robot.walk(0, 0, Walk.MOST_TURN, () -> robot.turnedDegrees() >= 360);
            return new Outcome(robot.endsStanding(), 360 / seconds);
        });
    }

    private static MotionCheck getUp(String name, String fall) {
        return check(name, "stands within 10 s after " + fall, "s", (robot, seed) -> {
            robot.perform(fall);
            robot.hold(1 + 0.1 * (seed % 7));
            robot.forgetFall();
            double before = robot.seconds();
            robot.perform(name);
            double seconds = robot.seconds() - before;
            robot.forgetFall();
            return new Outcome(robot.endsStanding() && seconds <= 10, seconds);
        });
    }

    private static MotionCheck kick(String name, double least, double most, String rule) {
        return check(name, rule + ", the robot stands", "m", (robot, seed) -> {
            BallPlace place = ShippedMotions.file(name).ball().orElseThrow().near(new Random(seed));
            Vector3 start = robot.place(place.ahead(), place.left(), BALL_RADIUS);
            robot.ball().place(start);
            robot.perform(name);
            boolean stands = robot.endsStanding();
            robot.hold(6);
            double metres = robot.ball().position().x() - start.x();
            return new Outcome(stands && metres >= least && metres <= most, metres);
        });
    }

    private static MotionCheck check(
            String name, String rule, String unit, BiFunction<ServedRobot, Long, Outcome> trial) {
        return new MotionCheck(name + SERVER, START, rule, unit, seed -> {
            try (ServedRobot robot = new ServedRobot(seed)) {
                return trial.apply(robot, seed);
            }
        });
    }
}
