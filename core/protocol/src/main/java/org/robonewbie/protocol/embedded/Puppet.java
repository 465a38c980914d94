package org.robonewbie.protocol.embedded;

import org.robonewbie.nao.Joint;

/** A robot under manual control. All methods return immediately and may be called from any thread. */
public interface Puppet extends AutoCloseable {

    /**
     * Sets the walking velocity, which stays in effect until the next call. Zero stops the robot.
     *
     * @param forward fraction of the maximum forward speed, -1 to 1
     * @param left fraction of the maximum speed to the left, -1 to 1
     * @param turn fraction of the maximum turning speed to the left, -1 to 1
     */
    void walk(double forward, double left, double turn);

    /**
     * Plays a motion from the framework's library.
     *
     * @param motion name of the motion, such as {@code kick-right}
     */
    void perform(String motion);

    /**
     * Turns the head.
     *
     * @param yawDegrees angle to the left in degrees
     * @param pitchDegrees angle up in degrees
     */
    void look(double yawDegrees, double pitchDegrees);

    /**
     * Moves a joint to an angle and holds it there. Stops walking and motions.
     *
     * @param joint the joint
     * @param degrees target angle in degrees, clamped to the joint's range
     */
    void hold(Joint joint, double degrees);

    /** Releases all joints and returns to a standing posture. */
    void stand();

    /** Removes the robot from the pitch. */
    @Override
    void close();
}
