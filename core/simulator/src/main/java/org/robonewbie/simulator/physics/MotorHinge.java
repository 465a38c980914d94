package org.robonewbie.simulator.physics;

/** Hinge with a motor that maintains a target speed within its torque limit. */
public interface MotorHinge {

    /** {@return the angle of the child relative to the parent in radians, 0 in the pose in which the hinge was created} */
    double angleRadians();

    /**
     * Sets the target speed of the motor. Does not wake a sleeping body.
     *
     * @param radiansPerSecond target speed; 0 holds the angle
     */
    void setSpeed(double radiansPerSecond);
}
