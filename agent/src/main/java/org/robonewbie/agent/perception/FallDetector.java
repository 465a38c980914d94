package org.robonewbie.agent.perception;

import org.robonewbie.nao.Vector3;

/**
 * Feels with the accelerometer which way is up. At rest the accelerometer points away from the ground with 9.81 m/s²; the
 * knocks of walking feet are much stronger but short, so they are cut off and smoothed away.
 */
public final class FallDetector {

    private static final double SMOOTHING_SECONDS = 0.2;
    private static final double CYCLE_SECONDS = 0.02;
    private static final double STRONGEST = 20;
    private static final double COSINE_OF_FALL = Math.cos(Math.toRadians(60));
    private static final Vector3 STANDING = new Vector3(0, 0, 9.81);

    private Vector3 up = STANDING;

    /** Creates a detector that believes the robot to stand. */
    public FallDetector() {}

    /**
     * Takes in a reading.
     *
     * @param acceleration of the torso: x forward, y left, z up, in m/s²; what is no number is ignored
     */
    public void feel(Vector3 acceleration) {
        double strength = acceleration.length();
        if (!Double.isFinite(strength)) {
            return;
        }
        double bound = strength > STRONGEST ? STRONGEST / strength : 1;
        double share = CYCLE_SECONDS / SMOOTHING_SECONDS;
        up = new Vector3(
                up.x() + share * (bound * acceleration.x() - up.x()),
                up.y() + share * (bound * acceleration.y() - up.y()),
                up.z() + share * (bound * acceleration.z() - up.z()));
    }

    /** Believes the robot to stand, after it was put somewhere else. */
    public void reset() {
        up = STANDING;
    }

    /**
     * Tells how far the torso leans.
     *
     * @return degrees between the torso and the direction away from the ground, 0 to 180
     */
    public double tiltDegrees() {
        double length = up.length();
        return length == 0 ? 0 : Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, up.z() / length))));
    }

    /**
     * Tells how the robot is.
     *
     * @return upright, or on which side it lies
     */
    public BodyPosition bodyPosition() {
        if (up.z() >= COSINE_OF_FALL * up.length()) {
            return BodyPosition.UPRIGHT;
        }
        if (Math.abs(up.x()) >= Math.abs(up.y())) {
            return up.x() > 0 ? BodyPosition.LYING_ON_BACK : BodyPosition.LYING_ON_FRONT;
        }
        return up.y() > 0 ? BodyPosition.LYING_ON_RIGHT_SIDE : BodyPosition.LYING_ON_LEFT_SIDE;
    }
}
