package org.robonewbie.learning.measure;

import java.util.function.LongFunction;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.learning.rehearsal.LineKeeping;
import org.robonewbie.learning.rehearsal.LongWay;
import org.robonewbie.learning.rehearsal.Rehearsal;
import org.robonewbie.nao.model.RobotType;

/**
 * Where a check is made with a robot that begins in the stance.
 *
 * @param suffix what the names of its checks end with
 * @param words how each trial begins
 * @param opening brings the robot into the stance
 */
record CheckStart(String suffix, String words, LongFunction<Rehearsal> opening) {

    private static final String ON_LEAGUE_PITCH =
            "an agent on an own simulator with noise and the league's pitch, in the stance, reached from a posture"
                    + " beside it; pushed by a hand each second";

    /** A robot in a bare world, pushed by a hand. */
    static final CheckStart BARE =
            new CheckStart("", "stance, reached from a posture beside it", seed -> Rehearsal.inStance(seed, 3));

    /** A robot in a bare world with the ball at its feet. */
    static CheckStart kicker(RobotType type) {
        return new CheckStart(
                suffix(type),
                "stance, ball up to 1 cm beside the place that the file names, along each axis",
                seed -> Rehearsal.inStance(type, seed, 2));
    }

    /** An agent on a whole simulator. */
    static CheckStart server(RobotType type) {
        return new CheckStart(
                ", on the server" + suffix(type),
                "an agent on an own simulator with noise, in the stance",
                seed -> Rehearsal.served(seed, type));
    }

    /** An agent on a whole simulator, with room for long ways. */
    static CheckStart onLeaguePitch(RobotType type, WalkStyle style) {
        return new CheckStart(suffix(type), ON_LEAGUE_PITCH, seed -> LongWay.walking(seed, type, style));
    }

    /** An agent on a whole simulator, with room for a ball that goes far. */
    static CheckStart serverOnLeaguePitch(RobotType type) {
        return new CheckStart(
                ", on the server" + suffix(type),
                ON_LEAGUE_PITCH,
                seed -> LongWay.walking(seed, type, WalkStyle.STANDARD));
    }

    /** An agent that runs as it has learned and steers by what it sees and feels, else as {@link #onLeaguePitch(RobotType, WalkStyle)}. */
    static CheckStart onLeaguePitch(RobotType type, PolicyWalk learned, LineKeeping keeping) {
        return new CheckStart(
                suffix(type),
                ON_LEAGUE_PITCH + "; it steers by its own sensors",
                seed -> LongWay.running(seed, type, learned, keeping));
    }

    /** What the names of checks end with if the robot is not the usual one. */
    static String suffix(RobotType type) {
        return type == RobotType.TYPE_0 ? "" : ", type " + type.ordinal();
    }

    /** What the robot does, and what comes of it. */
    interface Act {

        Outcome of(Rehearsal robot, long seed);
    }

    MotionCheck check(String name, String rule, String unit, Act act) {
        return new MotionCheck(name + suffix, words, rule, unit, seed -> {
            try (Rehearsal robot = opening.apply(seed)) {
                return act.of(robot, seed);
            }
        });
    }
}
