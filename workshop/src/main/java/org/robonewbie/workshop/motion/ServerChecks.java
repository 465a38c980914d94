package org.robonewbie.workshop.motion;

import java.util.List;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Repeats the most important checks with an agent in a full simulator instead of a world without a server. */
final class ServerChecks {

    private ServerChecks() {}

    static List<MotionCheck> all(RobotType type) {
        CheckStart start = CheckStart.server(type);
        return List.of(
                WalkChecks.walk(start, "walk-forward"),
                WalkChecks.walk(start, "walk-forward-fast"),
                EngineChecks.forward(start),
                EngineChecks.turn(start),
                getUp(start, "stand-up-from-back", "fall-back"),
                getUp(start, "stand-up-from-front", "fall-forward"),
                getUp(start, type.ownMotion("quick-stand-up-from-back"), "fall-back"),
                getUp(start, type.ownMotion("quick-stand-up-from-front"), "fall-forward"),
                KickChecks.kick(start, "kick-right"),
                KickChecks.pass(start, "pass-right"),
                KickChecks.farKick(CheckStart.serverOnLeaguePitch(type), "far-kick-right"));
    }

    private static MotionCheck getUp(CheckStart start, String name, String fall) {
        return start.check(name, "stands within 10 s after " + fall, "s", (robot, seed) -> {
            robot.allowFalls();
            robot.play(ShippedMotions.motion(fall));
            robot.hold(1 + 0.1 * (seed % 7));
            robot.begin(false);
            robot.play(ShippedMotions.motion(name));
            double seconds = robot.seconds();
            return new Outcome(robot.endsInStance() && seconds <= 10, seconds);
        });
    }
}
