package org.robonewbie.agent.cycle;

import org.robonewbie.nao.T1Joint;

/** The joints of a T1 with their own angles and motors. */
public interface OwnJoints {

    /**
     * Returns the angle of a joint.
     *
     * @param joint the joint
     * @return its measured angle in degrees
     */
    double degrees(T1Joint joint);

    /**
     * Sets the target of a motor and leaves its gains at those with which the robot stands.
     *
     * @param joint the joint
     * @param degrees target angle in degrees, within the joint's range
     */
    void setTarget(T1Joint joint, double degrees);

    /**
     * Sets the target and the gains of a motor.
     *
     * @param joint the joint
     * @param degrees target angle in degrees, within the joint's range
     * @param stiffness stiffness in newton metres per radian
     * @param damping damping in newton metres per radian per second
     */
    void setTarget(T1Joint joint, double degrees, double stiffness, double damping);
}
