package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/**
 * The last sensor reading of each joint's angle; 0 before the first reading.
 *
 * <pre>{@code
 * joints.sense(Joint.NECK_YAW, 12.5);
 * double degrees = joints.degrees(Joint.NECK_YAW);
 * }</pre>
 */
public final class JointStates {

    private final double[] degrees = new double[Joint.COUNT];

    /** Creates joint states with all angles at 0. */
    public JointStates() {}

    /**
     * Stores the reading of a joint's sensor.
     *
     * @param joint the joint
     * @param newDegrees its angle in degrees; NaN stands for a missing reading and leaves the last one unchanged
     */
    public void sense(Joint joint, double newDegrees) {
        if (Double.isFinite(newDegrees)) {
            degrees[joint.ordinal()] = newDegrees;
        }
    }

    /**
     * {@return the last sensed angle of a joint in degrees}
     *
     * @param joint the joint
     */
    public double degrees(Joint joint) {
        return degrees[joint.ordinal()];
    }

    /** {@return the last sensed angles of all joints} */
    public Posture posture() {
        return Posture.of(degrees);
    }
}
