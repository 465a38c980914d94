package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * A motion played from a given start: the posture at each moment, to look at an interpolation between the robot's cycles.
 *
 * @param start where the robot is when the motion begins
 * @param motion the motion
 * @param interpolation how the joints move between keyframes
 */
record MotionCourse(Posture start, Motion motion, Interpolation interpolation) {

    /**
     * Returns the posture at a moment.
     *
     * @param millis time since the beginning of the motion in milliseconds
     * @return the posture; the start before the beginning, the last keyframe's after the end
     */
    Posture postureAt(double millis) {
        double sectionStart = 0;
        if (millis <= 0 || motion.keyframes().isEmpty()) {
            return start;
        }
        for (int i = 0; i < motion.keyframes().size(); i++) {
            int duration = motion.keyframes().get(i).durationMillis();
            if (millis < sectionStart + duration) {
                return interpolated(new KeyframeInterval(start, motion, i), (millis - sectionStart) / duration);
            }
            sectionStart += Math.max(0, duration);
        }
        return motion.keyframes().get(motion.keyframes().size() - 1).posture();
    }

    private Posture interpolated(KeyframeInterval section, double fraction) {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] = interpolation.degrees(section, joint, fraction);
        }
        return Posture.of(degrees);
    }
}
