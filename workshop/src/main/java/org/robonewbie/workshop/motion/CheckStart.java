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
 * Environment of a check with a robot that starts in its {@linkplain org.robonewbie.agent.walk.Stance standard stance}.
 *
 * @param suffix suffix for the names of the checks in this environment
 * @param words description of how each trial starts
 * @param opening creates a trial with the robot in its standard stance
 */
record CheckStart(String suffix, String words, LongFunction<MotionTrial> opening) {

    private static final String ON_LEAGUE_PITCH =
            "an agent on its own simulator with noise and the league's pitch, in the stance, reached from a nearby"
                    + " posture; pushed every second";

    private static final String STEERED = ON_LEAGUE_PITCH + "; it steers by its own sensors";

    private static final Pose2d FAR_END = new Pose2d(-14, 0, 0);
    private static final Vector3 BALL_ASIDE = new Vector3(0, -9, 0);
    private static final double PUSH_NEWTONS = 3;

    /** World without a server, in which pushes disturb the robot. */
    static final CheckStart BARE = new CheckStart(
            "", "stance, reached from a nearby posture", seed -> MotionTrial.inStance(seed, PUSH_NEWTONS));

    /** Returns an environment without a server, with the ball in front of the feet. */
    static CheckStart kicker(RobotType type) {
        return new CheckStart(
                suffix(type),
                "stance, ball up to 1 cm off the position given in the file, along each axis",
                seed -> MotionTrial.inStance(type, WalkStyle.STANDARD, seed, 2));
    }

    /** Returns an environment with an agent in a full simulator. */
    static CheckStart server(RobotType type) {
        Scene scene = Scene.of(MotionTrial.ROBOT.withType(type).after("stand")).withBall(MotionTrial.BALL_ASIDE);
        return new CheckStart(
                ", on the server" + suffix(type),
                "an agent on its own simulator with noise, in the stance",
                seed -> MotionTrial.served(scene, seed, new ScriptedAgent(WalkStyle.STANDARD)));
    }

    /** Returns an environment with an agent in a full simulator with the league pitch, for long walks. */
    static CheckStart onLeaguePitch(RobotType type, WalkStyle style) {
        return onLeaguePitch("", ON_LEAGUE_PITCH, type, () -> new ScriptedAgent(style));
    }

    /** Returns an environment with an agent in a full simulator with the league pitch, for long kicks. */
    static CheckStart serverOnLeaguePitch(RobotType type) {
        return onLeaguePitch(", on the server", ON_LEAGUE_PITCH, type, () -> new ScriptedAgent(WalkStyle.STANDARD));
    }

    /**
     * Returns an environment with an agent that runs with a learned gait and steers by its own sensors; otherwise like
     * {@link #onLeaguePitch(RobotType, WalkStyle)}.
     */
    static CheckStart onLeaguePitch(RobotType type, PolicyWalk learned, LineKeeping keeping) {
        return onLeaguePitch("", STEERED, type, () -> new ScriptedRunner(learned, keeping));
    }

    /** Returns the same environment with an agent that sprints. */
    static CheckStart sprinter(RobotType type) {
        return onLeaguePitch("", STEERED, type, ScriptedSprinter::new);
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

    /** Returns the suffix for the names of checks with a robot type other than 0. */
    static String suffix(RobotType type) {
        return type == RobotType.TYPE_0 ? "" : ", type " + type.ordinal();
    }

    /** Actions of a trial, and their outcome. */
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
