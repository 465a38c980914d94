package org.robonewbie.robot;

/** The motor of a joint. */
public sealed interface Motor {

    /**
     * A motor that is commanded by speed, as in SimSpark.
     *
     * @param maxDegreesPerSecond maximum speed in either direction in degrees per second
     */
    record Speed(double maxDegreesPerSecond) implements Motor {}

    /**
     * A motor with position control, as in RCSSServerMJ: torque = stiffness · (target angle − angle) + damping · (target
     * speed − speed), clamped to the maximum torque.
     *
     * @param maxNewtonMetres maximum torque in either direction in newton metres
     * @param stiffness gain with which the robot holds its stance, in newton metres per radian
     * @param damping gain with which the robot holds its stance, in newton metres per radian per second
     */
    record Torque(double maxNewtonMetres, double stiffness, double damping) implements Motor {}
}
