package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Scene;

/**
 * Get up from the front by correcting the motion {@code quick-stand-up-from-front}, and stay up, for 4 s in all, with the
 * reward of {@link GetUpTraining}. The robot has fallen with its arms anywhere, so that it lies differently in each episode.
 */
final class QuickGetUpTraining extends GetUpTraining {

    private static final Motion QUICK = ShippedMotions.motion("quick-stand-up-from-front");
    private static final double ARM_DEGREES = 40;
    private static final double LEG_DEGREES = 8;

    @Override
    public Scene scene(RandomSource ofTheEpisode) {
        super.scene(ofTheEpisode);
        return lying(posture -> changed(posture, ofTheEpisode));
    }

    private static Posture changed(Posture posture, RandomSource random) {
        Posture changed = posture;
        for (Joint joint : Joint.values()) {
            boolean arm = joint.name().contains("SHOULDER") || joint.name().contains("ARM");
            double most = arm ? ARM_DEGREES : LEG_DEGREES;
            changed = changed.with(joint, joint.clampDegrees(posture.degrees(joint) + random.between(-most, most)));
        }
        return changed;
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
