package org.robonewbie.simulator.physics;

/** Hinge with a motor that maintains a target speed within its torque limit. */
public interface MotorHinge {

    /** {@return the angle of the child relative to the parent in radians, 0 in the pose in which the hinge was created} */
    double angleRadians();

    /** {@return the speed at which the angle changes, in radians per second} */
    double radiansPerSecond();

    /**
     * {@return the torque in newton metres that motor and stop exerted in the last step; a positive torque increases the angle}
     */
    double torque();

    /**
     * Sets the target speed of the motor. Does not wake a sleeping body.
     *
     * @param radiansPerSecond target speed; 0 holds the angle
     */
    void setSpeed(double radiansPerSecond);

    /**
     * Sets the torque limit of the motor. The limit is not part of a saved state.
     *
     * @param newtonMetres maximum torque, above 0
     */
    void setMaxTorque(double newtonMetres);
}
