package org.robonewbie.learning.measure;

import java.util.List;
import java.util.function.LongFunction;
import org.robonewbie.learning.rehearsal.DiveTrial;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.learning.rehearsal.Rehearsal;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of the motions that end on the ground or begin there. */
final class FallChecks {

    private FallChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                fall("fall-forward", Lying.ON_FRONT),
                fall("fall-back", Lying.ON_BACK),
                rollOver(),
                dive("dive-left", 1),
                dive("dive-right", -1));
    }

    private static MotionCheck fall(String name, Lying end) {
        return check(name, "stance", end, seed -> Rehearsal.inStance(seed, 0));
    }

    private static MotionCheck rollOver() {
        String start = "lying on front after a fall, arms anywhere";
        return check("roll-over-to-back", start, Lying.ON_BACK, Lying.ON_FRONT::fallen);
    }

    private static MotionCheck check(String name, String start, Lying end, LongFunction<Rehearsal> opening) {
        return new MotionCheck(name, start, "ends " + end.words(), "s", seed -> {
            try (Rehearsal robot = opening.apply(seed)) {
                robot.allowFalls();
                robot.play(ShippedMotions.motion(name));
                double seconds = robot.seconds();
                robot.hold(1);
                return new Outcome(end.isTrueOf(robot.body()), seconds);
            }
        });
    }

    private static MotionCheck dive(String name, int side) {
        return new MotionCheck(
                name,
                "stance, 0.1 s after a shot at 2 m/s from 2 m away, to pass up to 0.6 m aside",
                "the ball does not get past the robot",
                "m aside of the ball's way",
                seed -> {
                    DiveTrial trial = DiveTrial.run(ShippedMotions.motion(name), seed, side);
                    return new Outcome(trial.blocked(), Math.abs(trial.passesAt()));
                });
    }
}
