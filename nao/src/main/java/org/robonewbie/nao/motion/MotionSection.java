package org.robonewbie.nao.motion;

/**
 * The way from one keyframe of a motion to the next, together with its neighbours, which a smooth curve needs.
 *
 * @param start where the robot was when the motion began
 * @param motion the motion
 * @param index which keyframe is at the end of the way, from 0
 */
public record MotionSection(Posture start, Motion motion, int index) {

    /** Checks the index. */
    public MotionSection {
        if (index < 0 || index >= motion.keyframes().size()) {
            throw new IllegalArgumentException("Motion " + motion.name() + " has "
                    + motion.keyframes().size() + " keyframes, so there is no keyframe " + index + ".");
        }
    }

    /**
     * Tells where the way begins.
     *
     * @return the posture at the beginning
     */
    public Posture from() {
        return postureAt(index - 1);
    }

    /**
     * Tells where the way ends.
     *
     * @return the posture at the end
     */
    public Posture to() {
        return postureAt(index);
    }

    /**
     * Tells where the way before begins.
     *
     * @return the posture before {@link #from}; the same as {@link #from} at the beginning of the motion
     */
    public Posture before() {
        return postureAt(index - 2);
    }

    /**
     * Tells where the way after this ends.
     *
     * @return the posture after {@link #to}; the same as {@link #to} at the end of the motion
     */
    public Posture after() {
        return postureAt(index + 1);
    }

    /**
     * Tells how long the way takes.
     *
     * @return milliseconds from {@link #from} to {@link #to}
     */
    public int durationMillis() {
        return durationAt(index);
    }

    /**
     * Tells how long the way before takes.
     *
     * @return milliseconds from {@link #before} to {@link #from}; 0 at the beginning of the motion
     */
    public int durationBeforeMillis() {
        return durationAt(index - 1);
    }

    /**
     * Tells how long the way after this takes.
     *
     * @return milliseconds from {@link #to} to {@link #after}; 0 at the end of the motion
     */
    public int durationAfterMillis() {
        return durationAt(index + 1);
    }

    private Posture postureAt(int keyframe) {
        if (keyframe < 0) {
            return start;
        }
        int last = motion.keyframes().size() - 1;
        return motion.keyframes().get(Math.min(keyframe, last)).posture();
    }

    private int durationAt(int keyframe) {
        boolean exists = keyframe >= 0 && keyframe < motion.keyframes().size();
        return exists ? motion.keyframes().get(keyframe).durationMillis() : 0;
    }
}
