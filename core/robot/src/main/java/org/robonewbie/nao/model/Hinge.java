package org.robonewbie.nao.model;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * A motorised hinge between two links. The robot has one for each {@link org.robonewbie.nao.Joint}, and robot type 4
 * has two more for its toes.
 *
 * @param perceptorName name of the angle sensor in SimSpark's messages
 * @param effectorName name of the motor in SimSpark's messages
 * @param child the outer link's name
 * @param parent the inner link's name
 * @param anchor a point on the axis relative to the torso's centre in the construction pose, in SimSpark's frame, metres
 * @param axis direction of the axis in the construction pose, length 1, in SimSpark's frame
 * @param minDegrees angle of the lower stop in degrees
 * @param maxDegrees angle of the upper stop in degrees
 * @param maxRadiansPerSecond maximum speed of the motor in radians per second
 */
public record Hinge(
        String perceptorName,
        String effectorName,
        String child,
        String parent,
        Vector3 anchor,
        Vector3 axis,
        double minDegrees,
        double maxDegrees,
        double maxRadiansPerSecond) {

    /** {@return the name of the {@link Joint} constant, such as {@code LEFT_KNEE_PITCH}; for a toe, the name of its motor} */
    public String jointName() {
        return Joint.ofEffector(effectorName).map(Joint::name).orElse(effectorName);
    }
}
