package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;

/**
 * Pose of a body in the world frame.
 *
 * @param position centre in metres
 * @param rotation rotation from body to world axes
 */
public record BodyPose(Vector3 position, RotationMatrix rotation) {

    /** The pose of the reference frame itself. */
    public static final BodyPose ORIGIN = new BodyPose(Vector3.ZERO, RotationMatrix.IDENTITY);

    /**
     * Transforms a point from the body frame to the world frame.
     *
     * @param local a point in the body frame
     * @return the point in the world frame
     */
    public Vector3 toWorld(Vector3 local) {
        return position.plus(rotation.apply(local));
    }

    /**
     * Transforms a pose from the body frame to the world frame.
     *
     * @param local a pose in the body frame
     * @return the pose in the world frame
     */
    public BodyPose times(BodyPose local) {
        return new BodyPose(toWorld(local.position), rotation.after(local.rotation));
    }

    /** {@return the pose of the world frame relative to the body frame} */
    public BodyPose inverse() {
        RotationMatrix back = rotation.inverse();
        return new BodyPose(back.apply(position).times(-1), back);
    }

    /**
     * Converts the pose of a robot's link from SimSpark's axes, x right and y forward, to those of {@link
     * org.robonewbie.nao.kinematics}.
     *
     * @return the pose in the world frame with x forward, y left, z up
     */
    public Pose toBodyAxes() {
        return SimSparkFrame.linkToBody(toPose());
    }

    /**
     * Converts the pose of a robot's link from the axes of {@link org.robonewbie.nao.kinematics} to SimSpark's.
     *
     * @param link pose in the world frame with x forward, y left, z up
     * @return the pose with x right and y forward
     */
    public static BodyPose ofBodyAxes(Pose link) {
        return of(SimSparkFrame.linkFromBody(link));
    }

    /**
     * Converts a pose with a quaternion without changing its axes.
     *
     * @param pose pose in the world frame
     * @return the same pose
     */
    public static BodyPose of(Pose pose) {
        return new BodyPose(pose.position(), RotationMatrix.of(pose.rotation()));
    }

    /** {@return the pose with a quaternion, without changing its axes} */
    public Pose toPose() {
        return new Pose(position, rotation.toQuaternion());
    }
}
