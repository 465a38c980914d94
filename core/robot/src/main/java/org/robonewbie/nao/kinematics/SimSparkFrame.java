package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;

/**
 * Converts between the body frame of this framework (x forward, y left, z up) and SimSpark's (x right, y forward, z
 * up). Both have their origin at the centre of the torso. Components are negated as {@code 0 - x}, which, unlike
 * {@code -x}, never yields a negative zero, so that readings of 0 print as 0.
 */
public final class SimSparkFrame {

    private static final Rotation LEFT_TURN = Rotation.about(new Vector3(0, 0, 1), 90);
    private static final Rotation RIGHT_TURN = LEFT_TURN.inverse();

    private SimSparkFrame() {}

    /**
     * Converts a vector from SimSpark's frame to the body frame.
     *
     * @param vector vector with x right, y forward, z up
     * @return the same vector with x forward, y left, z up
     */
    public static Vector3 toBody(Vector3 vector) {
        return new Vector3(vector.y(), 0 - vector.x(), vector.z());
    }

    /**
     * Converts a vector from the body frame to SimSpark's frame.
     *
     * @param vector vector with x forward, y left, z up
     * @return the same vector with x right, y forward, z up
     */
    public static Vector3 fromBody(Vector3 vector) {
        return new Vector3(0 - vector.y(), vector.x(), vector.z());
    }

    /**
     * Converts a pose from SimSpark's frame to the body frame.
     *
     * @param pose pose whose own frame and reference frame both have x right, y forward, z up
     * @return the same pose with x forward, y left, z up in both frames
     */
    public static Pose toBody(Pose pose) {
        Rotation turn = pose.rotation();
        return new Pose(toBody(pose.position()), new Rotation(turn.w(), turn.y(), -turn.x(), turn.z()));
    }

    /**
     * Converts a pose from the body frame to SimSpark's frame.
     *
     * @param pose pose whose own frame and reference frame both have x forward, y left, z up
     * @return the same pose with x right, y forward, z up in both frames
     */
    public static Pose fromBody(Pose pose) {
        Rotation turn = pose.rotation();
        return new Pose(fromBody(pose.position()), new Rotation(turn.w(), -turn.y(), turn.x(), turn.z()));
    }

    /**
     * Converts the axes of a link from SimSpark's convention. The pose stays in the world frame, which both conventions share.
     *
     * @param link pose of a link with x right, y forward, z up
     * @return the same pose of the link with x forward, y left, z up
     */
    public static Pose linkToBody(Pose link) {
        return new Pose(link.position(), link.rotation().times(LEFT_TURN));
    }

    /**
     * Converts the axes of a link to SimSpark's convention. The pose stays in the world frame, which both conventions share.
     *
     * @param link pose of a link with x forward, y left, z up
     * @return the same pose of the link with x right, y forward, z up
     */
    public static Pose linkFromBody(Pose link) {
        return new Pose(link.position(), link.rotation().times(RIGHT_TURN));
    }
}
