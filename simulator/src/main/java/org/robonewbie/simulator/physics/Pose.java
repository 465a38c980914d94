package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * Place and turn of a body in the world.
 *
 * @param position its centre in metres
 * @param rotation from its own axes to the world's
 */
public record Pose(Vector3 position, Rotation rotation) {

    /**
     * Converts a point of the body to the world frame.
     *
     * @param local a point relative to the body's centre along its axes
     * @return the same point in the world frame
     */
    public Vector3 toWorld(Vector3 local) {
        return position.plus(rotation.apply(local));
    }

    /**
     * Converts a point of the world to the body's frame.
     *
     * @param world a point in the world frame
     * @return the same point relative to the body's centre along its axes
     */
    public Vector3 toLocal(Vector3 world) {
        return rotation.applyInverse(world.minus(position));
    }
}
