package org.robonewbie.learning.measure;

import java.util.List;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** The most important checks once more, with an agent on a whole simulator instead of a robot in a bare world. */
final class ServerChecks {

    private ServerChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                WalkChecks.walk(CheckStart.SERVER, "walk-forward"),
                WalkChecks.walk(CheckStart.SERVER, "walk-forward-fast"),
                EngineChecks.forward(CheckStart.SERVER),
                EngineChecks.turn(CheckStart.SERVER),
                getUp("stand-up-from-back", "fall-back"),
                getUp("stand-up-from-front", "fall-forward"),
                KickChecks.kick(CheckStart.SERVER, "kick-right"),
                KickChecks.pass(CheckStart.SERVER, "pass-right"));
    }

    private static MotionCheck getUp(String name, String fall) {
        return CheckStart.SERVER.check(name, "stands within 10 s after " + fall, "s", (robot, seed) -> {
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
