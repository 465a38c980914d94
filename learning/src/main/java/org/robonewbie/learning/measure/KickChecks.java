package org.robonewbie.learning.measure;

import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.learning.trial.KickTrial;
import org.robonewbie.nao.motion.BallPlace;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of kicks and passes. */
final class KickChecks {

    private static final double STRONG_METRES = 4;
    private static final double SHORTEST_PASS_METRES = 1;
    private static final double LONGEST_PASS_METRES = 2;
    private static final String START = "stance, ball up to 1 cm beside the place that the file names, along each axis";

    private KickChecks() {}

    static List<MotionCheck> all() {
        return Stream.of("left", "right")
                .flatMap(side -> Stream.of(
                        kick(
                                "kick-" + side,
                                "the ball rolls at least 4 m, the robot ends in the stance",
                                STRONG_METRES,
                                99),
                        kick(
                                "pass-" + side,
                                "the ball rolls 1 to 2 m, the robot ends in the stance",
                                SHORTEST_PASS_METRES,
                                LONGEST_PASS_METRES)))
                .toList();
    }

    private static MotionCheck kick(String name, String rule, double least, double most) {
        return new MotionCheck(name, START, rule, "m", seed -> {
            MotionFile file = ShippedMotions.file(name);
            BallPlace ball = file.ball().orElseThrow();
            KickTrial trial = KickTrial.run(file.motion(), ball, seed);
            boolean far = trial.metres() >= least && trial.metres() <= most;
            return new Outcome(far && trial.standing(), trial.metres());
        });
    }
}
