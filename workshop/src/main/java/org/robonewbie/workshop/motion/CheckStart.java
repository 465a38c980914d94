package org.robonewbie.workshop.motion;

import java.util.function.LongFunction;
import java.util.function.Supplier;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.learning.motion.ScriptedRobot;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;

/**
 * Where a check is made with a robot that begins in the stance.
 *
 * @param suffix what the names of its checks end with
 * @param words how each trial begins
 * @param opening brings the robot into the stance
 */
record CheckStart(String suffix, String words, LongFunction<MotionTrial> opening) {

    private static final String ON_LEAGUE_PITCH =
            "an agent on an own simulator with noise and the league's pitch, in the stance, reached from a posture"
                    + " beside it; pushed by a hand each second";

    private static final Pose2d FAR_END = new Pose2d(-14, 0, 0);
    private static final Vector3 BALL_ASIDE = new Vector3(0, -9, 0);
    private static final double PUSH_NEWTONS = 3;

    /** A robot in a bare world, pushed by a hand. */
    static final CheckStart BARE = new CheckStart(
            "", "stance, reached from a posture beside it", seed -> MotionTrial.inStance(seed, PUSH_NEWTONS));

    /** A robot in a bare world with the ball at its feet. */
    static CheckStart kicker(RobotType type) {
        return new CheckStart(
                suffix(type),
                "stance, ball up to 1 cm beside the place that the file names, along each axis",
                seed -> MotionTrial.inStance(type, WalkStyle.STANDARD, seed, 2));
    }

    /** An agent on a whole simulator. */
    static CheckStart server(RobotType type) {
        Scene scene = Scene.of(MotionTrial.ROBOT.withType(type).after("stand")).withBall(MotionTrial.BALL_ASIDE);
        return new CheckStart(
                ", on the server" + suffix(type),
                "an agent on an own simulator with noise, in the stance",
                seed -> MotionTrial.served(scene, seed, new ScriptedAgent(WalkStyle.STANDARD)));
    }

    /** An agent on a whole simulator, with room for long ways. */
    static CheckStart onLeaguePitch(RobotType type, WalkStyle style) {
        return onLeaguePitch("", ON_LEAGUE_PITCH, type, () -> new ScriptedAgent(style));
    }

    /** An agent on a whole simulator, with room for a ball that goes far. */
    static CheckStart serverOnLeaguePitch(RobotType type) {
        return onLeaguePitch(", on the server", ON_LEAGUE_PITCH, type, () -> new ScriptedAgent(WalkStyle.STANDARD));
    }

    /** An agent that runs as it has learned and steers by what it sees and feels, else as {@link #onLeaguePitch(RobotType, WalkStyle)}. */
    static CheckStart onLeaguePitch(RobotType type, PolicyWalk learned, LineKeeping keeping) {
        String words = ON_LEAGUE_PITCH + "; it steers by its own sensors";
        return onLeaguePitch("", words, type, () -> new ScriptedRunner(learned, keeping));
    }

    private static CheckStart onLeaguePitch(String place, String words, RobotType type, Supplier<ScriptedRobot> robot) {
        Scene pitch = Scene.of(RobotStart.at(FAR_END).withType(type).after("stand"))
                .withParameters(SoccerParameters.league())
                .withBall(BALL_ASIDE);
        return new CheckStart(
                place + suffix(type),
                words,
                seed -> MotionTrial.served(pitch, seed, robot.get()).intoStance(seed, PUSH_NEWTONS));
    }

    /** What the names of checks end with if the robot is not the usual one. */
    static String suffix(RobotType type) {
        return type == RobotType.TYPE_0 ? "" : ", type " + type.ordinal();
    }

    /** What the robot does, and what comes of it. */
    interface Act {

        Outcome of(MotionTrial robot, long seed);
    }

    MotionCheck check(String name, String rule, String unit, Act act) {
        return new MotionCheck(name + suffix, words, rule, unit, seed -> {
            try (MotionTrial robot = opening.apply(seed)) {
                return act.of(robot, seed);
            }
        });
    }
}
