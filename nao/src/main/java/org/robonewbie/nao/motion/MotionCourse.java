package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * A motion as it runs from a certain start: tells the posture at each moment, for the animation in an editor and for everyone
 * who wants to follow a motion exactly.
 *
 * @param start where the robot is when the motion begins
 * @param motion the motion
 * @param interpolation how the joints move between keyframes
 */
public record MotionCourse(Posture start, Motion motion, Interpolation interpolation) {

    /**
     * Finds the posture at a moment.
     *
     * @param millis time since the beginning of the motion in milliseconds
     * @return the posture; the start before the beginning, the last keyframe's after the end
     */
    public Posture postureAt(double millis) {
        double sectionStart = 0;
        if (millis <= 0 || motion.keyframes().isEmpty()) {
            return start;
        }
        for (int i = 0; i < motion.keyframes().size(); i++) {
            int duration = motion.keyframes().get(i).durationMillis();
            if (millis < sectionStart + duration) {
                return interpolated(new MotionSection(start, motion, i), (millis - sectionStart) / duration);
            }
            sectionStart += Math.max(0, duration);
        }
        return motion.keyframes().get(motion.keyframes().size() - 1).posture();
    }

    private Posture interpolated(MotionSection section, double fraction) {
        double[] degrees = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] = interpolation.degrees(section, joint, fraction);
        }
        return Posture.of(degrees);
    }
}
