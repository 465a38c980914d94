package org.robonewbie.nao.motion;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Cycle;

/**
 * The playback rule of RoboNewbie 1.1, for files with the comment {@code // play: 1.1}.
 *
 * <p>A keyframe of T milliseconds has N = T / 20 cycles, rounded down. While more than one cycle remains, each joint
 * turns by the step (target - (sensed + previous step)) / (remaining - 1), where the previous step is that of the
 * previous cycle, or 0 in the first cycle of a keyframe. In the last cycle all joints stop. The trajectory is thus
 * replanned in each cycle from the sensed angles, the robot rests for one cycle at each keyframe, and a keyframe of one
 * cycle has no effect. A keyframe ends early when all steps are exactly 0. One more cycle follows the last keyframe.
 */
final class OriginalRule {

    private static final int CYCLE_MILLIS = 20;

    private final List<Keyframe> keyframes;
    private final double[] previous;
    private int keyframe;
    private int remaining;
    private int cycles;
    private boolean finished;

    OriginalRule(Motion motion) {
        keyframes = motion.keyframes();
        previous = new double[motion.jointSpace().size()];
        begin();
    }

    /** Starts again with the first keyframe. */
    void begin() {
        cycles = 0;
        finished = keyframes.isEmpty();
        approach(0);
    }

    private void approach(int index) {
        keyframe = index;
        remaining = index < keyframes.size() ? Math.max(1, keyframes.get(index).durationMillis() / CYCLE_MILLIS) : 0;
        Arrays.fill(previous, 0);
    }

    void step(Motors motors) {
        cycles++;
        if (keyframe == keyframes.size()) {
            motors.stopMotion();
            finished = true;
            return;
        }
        boolean resting = true;
        for (int i = 0; i < previous.length; i++) {
            double step = remaining > 1 ? nextStep(motors, i) : 0;
            previous[i] = step;
            motors.setMotionSpeed(i, step / Cycle.SECONDS);
            resting &= step == 0;
        }
        remaining--;
        if (resting) {
            approach(keyframe + 1);
        }
    }

    private double nextStep(Motors motors, int joint) {
        double expected = motors.joints().degrees(joint) + previous[joint];
        return (keyframes.get(keyframe).posture().degrees(joint) - expected) / (remaining - 1);
    }

    /**
     * Returns the zero-based index of the keyframe that the robot is approaching; after the end, the index of the last
     * one.
     */
    int keyframe() {
        return Math.max(0, Math.min(keyframe, keyframes.size() - 1));
    }

    int cycles() {
        return cycles;
    }

    boolean isFinished() {
        return finished;
    }
}
