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

    private final JointSpace space;
    private final double[] degrees;

    /** Creates the joint states of a NAO with all angles at 0. */
    public JointStates() {
        this(JointSpace.NAO);
    }

    /**
     * Creates the joint states of any robot with all angles at 0.
     *
     * @param space the joints of the robot
     */
    public JointStates(JointSpace space) {
        this.space = space;
        degrees = new double[space.size()];
    }

    /** {@return the joints of the robot} */
    public JointSpace jointSpace() {
        return space;
    }

    /**
     * Stores the reading of a joint's sensor.
     *
     * @param joint the joint
     * @param newDegrees its angle in degrees; NaN stands for a missing reading and leaves the last one unchanged
     */
    public void sense(Joint joint, double newDegrees) {
        sense(joint.ordinal(), newDegrees);
    }

    /**
     * Stores the reading of the sensor of a joint of any robot.
     *
     * @param joint index of the joint in {@link #jointSpace()}
     * @param newDegrees its angle in degrees; NaN stands for a missing reading and leaves the last one unchanged
     */
    public void sense(int joint, double newDegrees) {
        if (Double.isFinite(newDegrees)) {
            degrees[joint] = newDegrees;
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

    /**
     * {@return the last sensed angle of a joint of any robot in degrees}
     *
     * @param joint index of the joint in {@link #jointSpace()}
     */
    public double degrees(int joint) {
        return degrees[joint];
    }

    /** {@return the last sensed angles of all joints} */
    public Posture posture() {
        return Posture.of(space, degrees);
    }
}
