package org.robonewbie.exercises;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * Detects a built-in motion from the leg joints, which must pass through most of the motion's keyframes in the right order,
 * at any speed.
 */
final class RecognisedMotion {

    private static final double ALIKE_DEGREES = 4;
    private static final double MIN_SHARE = 0.7;
    private static final Set<Joint> LEGS = EnumSet.range(Joint.LEFT_HIP_YAW_PITCH, Joint.RIGHT_FOOT_ROLL);

    private final Motion motion;
    private final List<BodyState> seen = new ArrayList<>();

    RecognisedMotion(Motion motion) {
        this.motion = motion;
    }

    void see(BodyState robot) {
        seen.add(robot);
    }

    boolean isRecognised() {
        int met = 0;
        int from = 0;
        for (Keyframe keyframe : motion.keyframes()) {
            int next = firstLike(keyframe.posture(), from);
            if (next < seen.size()) {
                met++;
                from = next;
            }
        }
        return met >= MIN_SHARE * motion.keyframes().size();
    }

    private int firstLike(Posture posture, int from) {
        int i = from;
        while (i < seen.size() && !isLike(seen.get(i), posture)) {
            i++;
        }
        return i;
    }

    private static boolean isLike(BodyState robot, Posture posture) {
        return LEGS.stream().allMatch(joint -> Math.abs(robot.degrees(joint) - posture.degrees(joint)) < ALIKE_DEGREES);
    }
}
