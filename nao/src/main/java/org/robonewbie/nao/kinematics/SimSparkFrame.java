package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;

/**
 * Converts between the body frame of this framework (x forward, y to the left, z up) and SimSpark's (x to the right, y forward,
 * z up). Both have the same origin, the centre of the torso.
 */
public final class SimSparkFrame {

    private SimSparkFrame() {}

    /**
     * Converts a vector of SimSpark.
     *
     * @param vector x right, y forward, z up
     * @return the same vector with x forward, y left, z up
     */
    public static Vector3 toBody(Vector3 vector) {
        return new Vector3(vector.y(), -vector.x(), vector.z());
    }

    /**
     * Converts a vector to SimSpark.
     *
     * @param vector x forward, y left, z up
     * @return the same vector with x right, y forward, z up
     */
    public static Vector3 fromBody(Vector3 vector) {
        return new Vector3(-vector.y(), vector.x(), vector.z());
    }

    /**
     * Converts a pose of SimSpark.
     *
     * @param pose with x right, y forward, z up inside and outside
     * @return the same pose with x forward, y left, z up inside and outside
     */
    public static Pose toBody(Pose pose) {
        Rotation turn = pose.rotation();
        return new Pose(toBody(pose.position()), new Rotation(turn.w(), turn.y(), -turn.x(), turn.z()));
    }

    /**
     * Converts a pose to SimSpark.
     *
     * @param pose with x forward, y left, z up inside and outside
     * @return the same pose with x right, y forward, z up inside and outside
     */
    public static Pose fromBody(Pose pose) {
        Rotation turn = pose.rotation();
        return new Pose(fromBody(pose.position()), new Rotation(turn.w(), -turn.y(), turn.x(), turn.z()));
    }
}
