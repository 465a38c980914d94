package org.robonewbie.workshop.motion;

import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.robonewbie.agent.walk.PoseApproach;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;

/**
 * Checks of a player on the league pitch: in a full simulator with noise, an agent walks long distances and to target
 * poses.
 */
final class SkillChecks {

    private static final double LONG_WAY = 20;
    private static final double MAX_SECONDS = 15;
    private static final double SETTLED_METRES = 0.03;
    private static final double SETTLED_DEGREES = 3;
    private static final double NEAR_METRES = 0.05;
    private static final double NEAR_DEGREES = 5;

    private final RobotType type;
    private final String walk;
    private final WalkStyle style;

    private SkillChecks(RobotType type, String walk, WalkStyle style) {
        this.type = type;
        this.walk = walk;
        this.style = style;
    }

    static List<MotionCheck> all(RobotType type) {
        SkillChecks usual = new SkillChecks(type, "walk", WalkStyle.STANDARD);
        SkillChecks fast = new SkillChecks(type, "fast walk", WalkStyle.fast(type));
        Stream<MotionCheck> walks = Stream.of(usual, fast).flatMap(skill -> skill.walks().stream());
        return Stream.of(walks, RunChecks.all(type).stream(), usual.localisations().stream())
                .flatMap(checks -> checks)
                .toList();
    }

    private List<MotionCheck> walks() {
        return List.of(far(), drift(), turn(), pose());
    }

    private List<MotionCheck> localisations() {
        return List.of(
                localisation(
                        "place", "the median is at most 0.05 m", "m, median", 0.05, middle(LocalisationTrial::metres)),
                localisation(
                        "place, mostly", "95 % are at most 0.15 m", "m, 95 %", 0.15, most(LocalisationTrial::metres)),
                localisation(
                        "heading",
                        "the median is at most 2°",
                        "degrees, median",
                        2,
                        middle(LocalisationTrial::degrees)),
                localisation(
                        "heading, mostly", "95 % are at most 5°", "degrees, 95 %", 5, most(LocalisationTrial::degrees)),
                localisation(
                        "camera's height",
                        "95 % are at most 0.05 m",
                        "m, 95 %",
                        0.05,
                        most(LocalisationTrial::cameraMetres)),
                localisation(
                        "camera's tilt",
                        "the median is at most 2°",
                        "degrees, median",
                        2,
                        middle(LocalisationTrial::tiltDegrees)));
    }

    private static ToDoubleFunction<LocalisationTrial> middle(Function<LocalisationTrial, double[]> errors) {
        return trial -> LocalisationTrial.median(errors.apply(trial));
    }

    private static ToDoubleFunction<LocalisationTrial> most(Function<LocalisationTrial, double[]> errors) {
        return trial -> LocalisationTrial.most(errors.apply(trial));
    }

    private CheckStart start() {
        return CheckStart.onLeaguePitch(type, style);
    }

    private MotionCheck far() {
        String rule = "walks 20 m without a fall, stops, ends in the stance";
        return start().check(walk + " 20 m", rule, "m/s on average", (robot, seed) -> {
            walkFar(robot);
            double speed = robot.forward() / robot.seconds();
            return new Outcome(robot.stopWalking() && robot.endsInStance() && speed > 0, speed);
        });
    }

    private MotionCheck drift() {
        String rule = "the walked direction is within 10° of the initial heading";
        return start().check(walk + " 20 m, drift", rule, "degrees to either side", (robot, seed) -> {
            boolean up = walkFar(robot);
            double degrees = Math.abs(Math.toDegrees(Math.atan2(robot.left(), robot.forward())));
            return new Outcome(up && degrees <= 10, degrees);
        });
    }

    private boolean walkFar(MotionTrial robot) {
        WalkVelocity ahead = new WalkVelocity(style.most().forward(), 0, 0);
        return robot.walk(() -> ahead, () -> robot.forward() < LONG_WAY);
    }

    private MotionCheck turn() {
        String rule = "turns twice around, stops, ends in the stance";
        return start().check(walk + ", turn", rule, "°/s", (robot, seed) -> {
            WalkVelocity around = new WalkVelocity(0, 0, style.most().turn());
            robot.walk(() -> around, () -> robot.turnedDegrees() < 720);
            double speed = robot.turnedDegrees() / robot.seconds();
            return new Outcome(robot.stopWalking() && robot.endsInStance(), speed);
        });
    }

    private MotionCheck pose() {
        String rule = "stands within 5 cm and 5° of a pose 2 m ahead, turned by 90°";
        return start().check(walk + " to a pose", rule, "s until it stands", (robot, seed) -> {
            Pose2d first = robot.start();
            Pose2d target = new Pose2d(first.x() + 2, first.y(), first.degrees() + (seed % 2 == 0 ? 90 : -90));
            Supplier<WalkVelocity> steering = () -> towards(robot, target);
            robot.walk(
                    steering,
                    () -> !isAt(robot, target, SETTLED_METRES, SETTLED_DEGREES) && robot.seconds() < MAX_SECONDS);
            boolean stands = robot.stopWalking();
            double seconds = robot.seconds();
            boolean there = isAt(robot, target, NEAR_METRES, NEAR_DEGREES);
            return new Outcome(stands && there && robot.endsInStance(), seconds);
        });
    }

    private WalkVelocity towards(MotionTrial robot, Pose2d target) {
        Pose2d now = robot.trial().now().place();
        double turn = Angles.wrap(target.degrees() - now.degrees());
        return new PoseApproach(style).velocity(now.ahead(target.pointAt(0, 0)), now.left(target.pointAt(0, 0)), turn);
    }

    private static boolean isAt(MotionTrial robot, Pose2d target, double metres, double degrees) {
        Pose2d now = robot.trial().now().place();
        return now.distance(target.pointAt(0, 0)) <= metres
                && Math.abs(Angles.wrap(target.degrees() - now.degrees())) <= degrees;
    }

    private MotionCheck localisation(
            String what, String rule, String unit, double most, ToDoubleFunction<LocalisationTrial> value) {
        return new MotionCheck(
                "self-localisation, " + what + CheckStart.suffix(type),
                "an agent on its own simulator with noise, anywhere on the league's pitch, walks around for 60 s"
                        + " and is knocked over twice",
                rule,
                unit,
                seed -> {
                    double error = value.applyAsDouble(LocalisationTrial.run(seed, type, style));
                    return new Outcome(error <= most, error);
                });
    }
}
