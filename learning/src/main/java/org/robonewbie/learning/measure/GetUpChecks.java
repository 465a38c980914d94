package org.robonewbie.learning.measure;

import java.util.List;
import org.robonewbie.learning.rehearsal.GetUpTrial;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.nao.motion.file.ShippedMotions;

/** Checks of the motions that bring a fallen robot to its feet. */
final class GetUpChecks {

    private static final double MOST_SECONDS = 10;

    /** 50 trials where the others have 20. */
    private static final double THOROUGHNESS = 2.5;

    private GetUpChecks() {}

    static List<MotionCheck> all() {
        return List.of(
                getUp("stand-up-from-back", Lying.ON_BACK),
                getUp("stand-up-from-front", Lying.ON_FRONT),
                getUp("quick-stand-up-from-back", Lying.ON_BACK),
                getUp("quick-stand-up-from-front", Lying.ON_FRONT),
                getUp("stand-up-from-left-side", Lying.ON_LEFT),
                getUp("stand-up-from-right-side", Lying.ON_RIGHT));
    }

    private static MotionCheck getUp(String name, Lying lying) {
        return new MotionCheck(
                        name,
                        lying.words() + " after a fall, arms anywhere",
                        "stands in the stance within 10 s",
                        "s",
                        seed -> {
                            GetUpTrial trial = GetUpTrial.run(lying, ShippedMotions.motion(name), seed);
                            return new Outcome(trial.success() && trial.seconds() <= MOST_SECONDS, trial.seconds());
                        })
                .thoroughly(THOROUGHNESS);
    }
}
