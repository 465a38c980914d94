package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Pose and velocity of a rigid body, such as a link of a robot or the ball.
 *
 * @param pose pose in the world frame
 * @param velocity velocity of the centre in the world frame, metres per second
 * @param radiansPerSecond angular velocity in the world frame
 */
public record LinkMotion(BodyPose pose, Vector3 velocity, Vector3 radiansPerSecond) {

    /**
     * Computes the motion between two poses.
     *
     * @param before the previous pose
     * @param now the current pose
     * @param seconds time between them; 0 for a body at rest
     * @return the current pose and the mean velocity since the previous one
     */
    public static LinkMotion between(BodyPose before, BodyPose now, double seconds) {
        if (!(seconds > 0)) {
            return new LinkMotion(now, Vector3.ZERO, Vector3.ZERO);
        }
        Vector3 displacement = now.position().minus(before.position());
        Rotation rotation = now.rotation().after(before.rotation().inverse()).toQuaternion();
        Vector3 axis = new Vector3(rotation.x(), rotation.y(), rotation.z());
        double sine = axis.length();
        double radians = 2 * PortableMath.atan2(sine, rotation.w());
        return new LinkMotion(
                now,
                displacement.times(1 / seconds),
                sine < 1e-12 ? Vector3.ZERO : axis.times(radians / sine / seconds));
    }
}
