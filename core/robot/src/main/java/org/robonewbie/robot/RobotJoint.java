package org.robonewbie.robot;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.JointSpace;

/**
 * A hinge between a body and its parent.
 *
 * <p>An angle is the rotation of the body relative to its parent, following the right-hand rule about the axis.
 *
 * @param index index of the joint in {@link RobotModel#joints()}
 * @param name name of the joint, such as {@code LEFT_KNEE_PITCH} for the NAO; unique within the robot
 * @param perceptorName name of its angle sensor in the server's messages
 * @param effectorName name of its motor in the server's messages
 * @param body index of the outer body
 * @param anchor a point on the axis in the outer body's frame, in metres
 * @param axis direction of the axis in the outer body's frame, length 1
 * @param minDegrees smallest angle of the range in degrees
 * @param maxDegrees largest angle of the range in degrees
 * @param motor the motor
 * @param stanceDegrees angle in the stance in degrees
 */
public record RobotJoint(
        int index,
        String name,
        String perceptorName,
        String effectorName,
        int body,
        Vector3 anchor,
        Vector3 axis,
        double minDegrees,
        double maxDegrees,
        Motor motor,
        double stanceDegrees) {

    /**
     * Clamps an angle to the joint's range.
     *
     * @param degrees any angle in degrees; not NaN
     * @return the nearest angle within the range, in degrees
     */
    public double clampDegrees(double degrees) {
        return Math.max(minDegrees, Math.min(maxDegrees, degrees));
    }

    /** {@return name, range and maximum speed, as motions need them} */
    JointSpace.Limits limits() {
        double maxSpeed = motor instanceof Motor.Speed speed ? speed.maxDegreesPerSecond() : Double.POSITIVE_INFINITY;
        return new JointSpace.Limits(name, minDegrees, maxDegrees, maxSpeed);
    }
}
