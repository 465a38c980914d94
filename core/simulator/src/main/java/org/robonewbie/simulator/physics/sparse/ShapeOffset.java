package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.simulator.physics.BodyPose;

/** Pose of a shape that is not centred on its body. */
final class ShapeOffset {

    /** Centre in the world frame. */
    final double[] position = new double[3];
    /** Rotation from the shape's to the world's axes, row-major. */
    final double[] rotation = Rotations.identity();

    private final BodyPose relative;

    ShapeOffset(BodyPose relative) {
        this.relative = relative;
    }

    void follow(BodyPose body) {
        BodyPose pose = body.times(relative);
        Rotations.set(
                position,
                0,
                pose.position().x(),
                pose.position().y(),
                pose.position().z());
        Rotations.copy(pose.rotation(), rotation);
    }
}
