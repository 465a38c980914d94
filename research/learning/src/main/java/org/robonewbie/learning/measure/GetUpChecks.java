package org.robonewbie.learning.measure;

import java.util.List;
import org.robonewbie.learning.rehearsal.GetUpTrial;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * Checks of the motions that bring a fallen robot to its feet.
 *
 * @param type how the robot is built
 */
record GetUpChecks(RobotType type) {

    private static final double MOST_SECONDS = 10;

    /** 50 trials where the others have 20. */
    private static final double THOROUGHNESS = 2.5;

    List<MotionCheck> all() {
        return List.of(
                getUp("stand-up-from-back", Lying.ON_BACK),
                getUp("stand-up-from-front", Lying.ON_FRONT),
                getUp(type.ownMotion("quick-stand-up-from-back"), Lying.ON_BACK),
                getUp(type.ownMotion("quick-stand-up-from-front"), Lying.ON_FRONT),
                getUp("stand-up-from-left-side", Lying.ON_LEFT),
                getUp("stand-up-from-right-side", Lying.ON_RIGHT));
    }

    private MotionCheck getUp(String name, Lying lying) {
        return new MotionCheck(
                        name + CheckStart.suffix(type),
                        lying.words() + " after a fall, arms anywhere",
                        "stands in the stance within 10 s",
                        "s",
                        seed -> {
                            GetUpTrial trial = GetUpTrial.run(lying, type, ShippedMotions.motion(name), seed);
                            return new Outcome(trial.success() && trial.seconds() <= MOST_SECONDS, trial.seconds());
                        })
                .thoroughly(THOROUGHNESS);
    }
}
