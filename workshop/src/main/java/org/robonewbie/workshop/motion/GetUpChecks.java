package org.robonewbie.workshop.motion;

import java.util.List;
import org.robonewbie.learning.motion.FallenPose;
import org.robonewbie.learning.motion.MotionTrial;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * Checks of the get-up motions.
 *
 * @param type the robot type
 */
record GetUpChecks(RobotType type) {

    private static final double MAX_SECONDS = 10;
    private static final double SETTLING_SECONDS = 1;

    /** Thoroughness that yields 50 trials instead of 20. */
    private static final double THOROUGHNESS = 2.5;

    List<MotionCheck> all() {
        return List.of(
                getUp("stand-up-from-back", FallenPose.ON_BACK),
                getUp("stand-up-from-front", FallenPose.ON_FRONT),
                getUp(type.ownMotion("quick-stand-up-from-back"), FallenPose.ON_BACK),
                getUp(type.ownMotion("quick-stand-up-from-front"), FallenPose.ON_FRONT),
                getUp("stand-up-from-left-side", FallenPose.ON_LEFT),
                getUp("stand-up-from-right-side", FallenPose.ON_RIGHT));
    }

    private MotionCheck getUp(String name, FallenPose lying) {
        return new MotionCheck(
                        name + CheckStart.suffix(type),
                        lying.words() + " after a fall, arms in any position",
                        "stands in the stance within 10 s",
                        "s",
                        seed -> getUp(name, lying, seed))
                .thoroughly(THOROUGHNESS);
    }

    private Outcome getUp(String name, FallenPose lying, long seed) {
        try (MotionTrial robot = lying.fallen(type, seed)) {
            robot.play(ShippedMotions.motion(name));
            double seconds = robot.seconds();
            boolean stands = robot.hold(SETTLING_SECONDS) && robot.isInStance();
            return new Outcome(stands && seconds <= MAX_SECONDS, seconds);
        }
    }
}
