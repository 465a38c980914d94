package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;

/**
 * Where something is and how it is turned, as seen from something else.
 *
 * @param position place of its origin in metres
 * @param rotation how its axes are turned
 */
public record Pose(Vector3 position, Rotation rotation) {

    /** At the origin and not turned. */
    public static final Pose ORIGIN = new Pose(Vector3.ZERO, Rotation.NONE);

    /**
     * Says where a point of this thing is.
     *
     * @param point a point as seen from this thing, in metres
     * @return the same point as seen from where this pose is seen
     */
    public Vector3 transform(Vector3 point) {
        return position.plus(rotation.apply(point));
    }

    /**
     * Says where another thing is that is known relative to this one.
     *
     * @param inner the other thing as seen from this one
     * @return the other thing as seen from where this pose is seen
     */
    public Pose times(Pose inner) {
        return new Pose(transform(inner.position), rotation.times(inner.rotation));
    }

    /**
     * Exchanges observer and observed.
     *
     * @return how the observer is seen from this thing
     */
    public Pose inverse() {
        Rotation back = rotation.inverse();
        return new Pose(back.apply(position).times(-1), back);
    }
}
