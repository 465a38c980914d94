package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Where a link of a robot, or the ball, is and how it moves.
 *
 * @param pose its place in the world frame
 * @param velocity of its centre in the world frame, metres per second
 * @param radiansPerSecond axis and speed of its turn in the world frame
 */
public record LinkMotion(BodyPose pose, Vector3 velocity, Vector3 radiansPerSecond) {

    /**
     * Calculates the motion between two poses.
     *
     * @param before the previous pose
     * @param now the present pose
     * @param seconds time between the two; 0 for a link at rest
     * @return the present pose and the mean velocity since the previous one
     */
    public static LinkMotion between(BodyPose before, BodyPose now, double seconds) {
        if (!(seconds > 0)) {
            return new LinkMotion(now, Vector3.ZERO, Vector3.ZERO);
        }
        Vector3 way = now.position().minus(before.position());
        double[] turn = now.rotation().after(before.rotation().inverse()).toQuaternion();
        Vector3 axis = new Vector3(turn[1], turn[2], turn[3]);
        double sine = axis.length();
        double radians = 2 * PortableMath.atan2(sine, turn[0]);
        return new LinkMotion(
                now, way.times(1 / seconds), sine < 1e-12 ? Vector3.ZERO : axis.times(radians / sine / seconds));
    }
}
