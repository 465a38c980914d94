package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;

/**
 * Position and orientation of one frame relative to another.
 *
 * @param position the frame's origin in metres
 * @param rotation the frame's orientation
 */
public record Pose(Vector3 position, Rotation rotation) {

    /** The identity: at the origin, not rotated. */
    public static final Pose ORIGIN = new Pose(Vector3.ZERO, Rotation.NONE);

    /**
     * Transforms a point from this frame to the reference frame.
     *
     * @param point a point in this frame, in metres
     * @return the same point in the reference frame
     */
    public Vector3 transform(Vector3 point) {
        return position.plus(rotation.apply(point));
    }

    /**
     * Composes two poses.
     *
     * @param inner the pose of another frame relative to this one
     * @return the pose of the other frame relative to this pose's reference frame
     */
    public Pose times(Pose inner) {
        return new Pose(transform(inner.position), rotation.times(inner.rotation));
    }

    /** {@return the inverse: the pose of the reference frame relative to this frame} */
    public Pose inverse() {
        Rotation back = rotation.inverse();
        return new Pose(back.apply(position).times(-1), back);
    }
}
