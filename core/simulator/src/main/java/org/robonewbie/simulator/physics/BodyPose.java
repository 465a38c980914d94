package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;

/**
 * Position and orientation of a body in the world.
 *
 * @param position its centre in metres
 * @param rotation from its own axes to the world's
 */
public record BodyPose(Vector3 position, RotationMatrix rotation) {

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

    /**
     * Converts the pose of a robot's link, which has x to the right and y forward, to the axes of {@link
     * org.robonewbie.nao.kinematics}.
     *
     * @return the same pose in the world frame with x forward, y left, z up
     */
    public org.robonewbie.nao.kinematics.Pose toBodyAxes() {
        return SimSparkFrame.linkToBody(new org.robonewbie.nao.kinematics.Pose(position, rotation.toTurn()));
    }

    /**
     * Converts the pose of a robot's link back from the axes of {@link org.robonewbie.nao.kinematics}.
     *
     * @param link its pose in the world frame with x forward, y left, z up
     * @return the same pose with x to the right and y forward
     */
    public static BodyPose ofBodyAxes(org.robonewbie.nao.kinematics.Pose link) {
        org.robonewbie.nao.kinematics.Pose own = SimSparkFrame.linkFromBody(link);
        return new BodyPose(own.position(), RotationMatrix.of(own.rotation()));
    }

    /**
     * Takes on the pose of anything but a link, whose axes are its own.
     *
     * @param pose its pose in the world frame
     * @return the same pose
     */
    public static BodyPose of(org.robonewbie.nao.kinematics.Pose pose) {
        return new BodyPose(pose.position(), RotationMatrix.of(pose.rotation()));
    }

    /** {@return the same pose for anything but a link} */
    public org.robonewbie.nao.kinematics.Pose toPose() {
        return new org.robonewbie.nao.kinematics.Pose(position, rotation.toTurn());
    }
}
