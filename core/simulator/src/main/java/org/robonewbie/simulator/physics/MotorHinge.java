package org.robonewbie.simulator.physics;

/** A hinge whose motor holds a speed within the limits of its torque. */
public interface MotorHinge {

    /**
     * Measures the angle of the child against the parent.
     *
     * @return radians, 0 in the pose in which the hinge was made
     */
    double angleRadians();

    /**
     * Sets the speed that the motor tries to hold until the next call; it does not wake a sleeping body.
     *
     * @param radiansPerSecond the speed; 0 holds the angle
     */
    void setSpeed(double radiansPerSecond);
}
