package org.robonewbie.learning.measure;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.learning.rehearsal.KickTrial;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of kicks and passes. */
final class KickChecks {

    private static final double STRONG_METRES = 4;
    private static final double SHORTEST_PASS_METRES = 1;
    private static final double LONGEST_PASS_METRES = 2;

    private KickChecks() {}

    static List<MotionCheck> all() {
        return Stream.of("left", "right")
                .flatMap(side ->
                        Stream.of(kick(CheckStart.KICKER, "kick-" + side), pass(CheckStart.KICKER, "pass-" + side)))
                .toList();
    }

    static MotionCheck kick(CheckStart start, String name) {
        return kick(start, name, "the ball rolls at least 4 m, the robot ends in the stance", STRONG_METRES, 99);
    }

    static MotionCheck pass(CheckStart start, String name) {
        String rule = "the ball rolls 1 to 2 m, the robot ends in the stance";
        return kick(start, name, rule, SHORTEST_PASS_METRES, LONGEST_PASS_METRES);
    }

    private static MotionCheck kick(CheckStart start, String name, String rule, double least, double most) {
        return start.check(name, rule, "m", (robot, seed) -> {
            MotionFile file = ShippedMotions.file(name);
            KickTrial trial =
                    KickTrial.toTheEnd(robot, file.motion(), file.ball().orElseThrow(), seed);
            boolean far = trial.metres() >= least && trial.metres() <= most;
            return new Outcome(far && trial.standing(), trial.metres());
        });
    }
}
