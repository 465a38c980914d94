package org.robonewbie.robot;

import org.robonewbie.nao.math.PortableMath;

/** The motor of a joint. */
public sealed interface Motor {

    /**
     * A motor that is commanded by speed, as in SimSpark.
     *
     * @param maxRadiansPerSecond maximum speed in either direction in radians per second, the unit of SimSpark's figures
     */
    record Speed(double maxRadiansPerSecond) implements Motor {

        /**
         * Creates a motor.
         *
         * @param maxDegreesPerSecond maximum speed in either direction in degrees per second
         * @return the motor
         */
        public static Speed ofDegrees(double maxDegreesPerSecond) {
            return new Speed(PortableMath.toRadians(maxDegreesPerSecond));
        }

        /** {@return the maximum speed in either direction in degrees per second} */
        public double maxDegreesPerSecond() {
            return PortableMath.toDegrees(maxRadiansPerSecond);
        }
    }

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
