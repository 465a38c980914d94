package org.robonewbie.agent.walk;

import org.robonewbie.nao.motion.Posture;

/**
 * The posture in which motions begin and end: knees bent, torso a little forward, arms hanging with bent elbows. The motion
 * {@code stand} leads there.
 */
public final class Stance {

    /** The stance. */
    public static final Posture POSTURE =
            Posture.of(0, 0, -95, 10, -90, -40, 0, 0, 35, -70, 37, 0, 0, 0, 35, -70, 37, 0, -95, -10, 90, 40);

    private Stance() {}
}
