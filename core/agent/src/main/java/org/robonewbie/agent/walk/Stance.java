package org.robonewbie.agent.walk;

import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.motion.Posture;

/**
 * The standing posture in which motions begin and end: knees bent, torso leaning slightly forward, arms down with bent
 * elbows. The motion {@code stand} ends in this posture.
 */
public final class Stance {

    /** Joint angles of this posture. */
    public static final Posture POSTURE =
            Posture.of(0, 0, -95, 10, -90, -40, 0, 0, 35, -70, 37, 0, 0, 0, 35, -70, 37, 0, -95, -10, 90, 40);

    /** Half the distance between the feet, in metres. */
    public static final double HALF_WIDTH = 0.055;

    /** Pose of the left foot, at the point of its sole below the ankle. */
    public static final Pose2d LEFT_FOOT = new Pose2d(0, HALF_WIDTH, 0);

    /** Pose of the right foot, at the point of its sole below the ankle. */
    public static final Pose2d RIGHT_FOOT = new Pose2d(0, -HALF_WIDTH, 0);

    private Stance() {}
}
