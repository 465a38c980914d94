package org.robonewbie.nao.motion;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * The rule by which RoboNewbie 1.1 played keyframes, for files that were made for it: {@code // play: 1.1}.
 *
 * <p>A keyframe of T milliseconds has N = T / 20 cycles, rounded down. With {@code left} cycles to go, and more than one, each joint gets
 * the step (target - (sensed + previous step)) / (left - 1), where the previous step is the one that was commanded a cycle before
 * in the same keyframe. In the last cycle all joints stop. So the way to a pose is planned again in each cycle from what is sensed, the robot rests
 * for one cycle at each keyframe, and a keyframe of one cycle is not approached at all. A keyframe ends early when all steps are
 * exactly 0. After the last one comes one more cycle.
 */
final class OriginalRule {

    private static final int CYCLE_MILLIS = 20;
    private static final Joint[] JOINTS = Joint.values();

    private final List<Keyframe> keyframes;
    private final double[] previous = new double[Joint.COUNT];
    private int keyframe;
    private int left;
    private int cycles;
    private boolean over;

    OriginalRule(Motion motion) {
        keyframes = motion.keyframes();
        begin();
    }

    /** Starts with the first keyframe. */
    void begin() {
        cycles = 0;
        over = keyframes.isEmpty();
        approach(0);
    }

    private void approach(int index) {
        keyframe = index;
        left = index < keyframes.size() ? cyclesOf(keyframes.get(index)) : 0;
        Arrays.fill(previous, 0);
    }

    void step(Motors motors) {
        cycles++;
        if (keyframe == keyframes.size()) {
            motors.stopMotion();
            over = true;
            return;
        }
        boolean resting = true;
        for (Joint joint : JOINTS) {
            double step = left > 1 ? nextStep(motors, joint) : 0;
            previous[joint.ordinal()] = step;
            motors.setMotionSpeed(joint, step / Cycle.SECONDS);
            resting &= step == 0;
        }
        left--;
        if (resting) {
            approach(keyframe + 1);
        }
    }

    private double nextStep(Motors motors, Joint joint) {
        double expected = motors.joints().degrees(joint) + previous[joint.ordinal()];
        return (keyframes.get(keyframe).posture().degrees(joint) - expected) / (left - 1);
    }

    /** The index of the keyframe that is being approached; the last one after the end. */
    int keyframe() {
        return Math.max(0, Math.min(keyframe, keyframes.size() - 1));
    }

    int cycles() {
        return cycles;
    }

    /** How many cycles the whole motion takes if no keyframe ends early. */
    int lengthInCycles() {
        int all = keyframes.stream().mapToInt(OriginalRule::cyclesOf).sum();
        return keyframes.isEmpty() ? 0 : all + 1;
    }

    boolean isOver() {
        return over;
    }

    private static int cyclesOf(Keyframe frame) {
        return Math.max(1, frame.durationMillis() / CYCLE_MILLIS);
    }
}
