package org.robonewbie.nao.motion;

/**
 * The interval between two consecutive keyframes of a motion, with the neighbouring keyframes that a smooth curve
 * needs.
 *
 * @param start the robot's posture when the motion began
 * @param motion the motion
 * @param index zero-based index of the keyframe at the end of the interval
 */
public record KeyframeInterval(Posture start, Motion motion, int index) {

    /** Rejects an index without a keyframe. */
    public KeyframeInterval {
        if (index < 0 || index >= motion.keyframes().size()) {
            throw new IllegalArgumentException("Keyframe " + index + " does not exist: motion " + motion.name()
                    + " has " + motion.keyframes().size() + " keyframes, numbered from 0.");
        }
    }

    /** {@return the posture at the beginning} */
    public Posture from() {
        return postureAt(index - 1);
    }

    /** {@return the posture at the end} */
    public Posture to() {
        return postureAt(index);
    }

    /** {@return the posture before {@link #from}; at the beginning of the motion, {@link #from} itself} */
    public Posture before() {
        return postureAt(index - 2);
    }

    /** {@return the posture after {@link #to}; at the end of the motion, {@link #to} itself} */
    public Posture after() {
        return postureAt(index + 1);
    }

    /** {@return the duration from {@link #from} to {@link #to} in milliseconds} */
    public int durationMillis() {
        return durationAt(index);
    }

    /** {@return the duration from {@link #before} to {@link #from} in milliseconds; 0 at the beginning of the motion} */
    public int durationBeforeMillis() {
        return durationAt(index - 1);
    }

    /** {@return the duration from {@link #to} to {@link #after} in milliseconds; 0 at the end of the motion} */
    public int durationAfterMillis() {
        return durationAt(index + 1);
    }

    /** Returns the angle of the joint with an index at constant speed; the fraction is 0 at {@link #from} and 1 at {@link #to}. */
    double linearDegrees(int joint, double fraction) {
        double begin = from().degrees(joint);
        double end = to().degrees(joint);
        return fraction >= 1 ? end : begin + fraction * (end - begin);
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
