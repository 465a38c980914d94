package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;

/**
 * Task: get up from lying on its front by correcting the motion {@code quick-stand-up-from-front}. The robot lies in a
 * different posture in each episode.
 */
final class QuickGetUpTraining extends GetUpTraining {

    private static final Motion QUICK = ShippedMotions.motion("quick-stand-up-from-front");
    private static final double ARM_DEGREES = 40;
    private static final double LEG_DEGREES = 8;

    @Override
    public Scene scene(RandomSource random) {
        return lying(posture -> randomized(posture, random));
    }

    private static Posture randomized(Posture posture, RandomSource random) {
        Posture result = posture;
        for (Joint joint : Joint.values()) {
            boolean arm = joint.name().contains("SHOULDER") || joint.name().contains("ARM");
            double max = arm ? ARM_DEGREES : LEG_DEGREES;
            result = result.with(joint, joint.clampDegrees(posture.degrees(joint) + random.between(-max, max)));
        }
        return result;
    }

    @Override
    public String rewardRule() {
        return "as GetUp, after a fall with the arms in random positions";
    }

    @Override
    public Optional<Motion> motion() {
        return Optional.of(QUICK);
    }

    @Override
    public double rangeDegrees() {
        return 20;
    }

    @Override
    public int longestCycles() {
        return 200;
    }
}
