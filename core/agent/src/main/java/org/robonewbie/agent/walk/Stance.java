package org.robonewbie.agent.walk;

import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.motion.Posture;

/**
 * The posture in which motions begin and end: knees bent, torso a little forward, arms hanging with bent elbows. The motion
 * {@code stand} leads there.
 */
public final class Stance {

    /** The stance. */
    public static final Posture POSTURE =
            Posture.of(0, 0, -95, 10, -90, -40, 0, 0, 35, -70, 37, 0, 0, 0, 35, -70, 37, 0, -95, -10, 90, 40);

    /** Half the distance between two feet that stand side by side below the hips, in metres. */
    public static final double HALF_WIDTH = 0.055;

    /** Where the left foot stands: the point of its sole below the ankle. */
    public static final Pose2d LEFT_FOOT = new Pose2d(0, HALF_WIDTH, 0);

    /** Where the right foot stands. */
    public static final Pose2d RIGHT_FOOT = new Pose2d(0, -HALF_WIDTH, 0);

    private Stance() {}
}
