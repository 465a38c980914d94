package org.robonewbie.agent.motion;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Motors;

/**
 * A smooth, elliptical head scan: down on the way out and up on the way back, so that the camera covers everything from
 * the robot's feet to the goals, over nearly 240° horizontally. It uses only the neck, so the body can play any
 * motion at the same time.
 *
 * <pre>{@code
 * private final LookAround lookAround = new LookAround(motors);
 * // in each cycle:
 * lookAround.look();
 * }</pre>
 */
public final class LookAround {

    /**
     * Duration of one scan in seconds. An object that has not been seen for longer than one scan is no longer where it
     * was last seen.
     */
    public static final double ROUND_SECONDS = 2.4;

    private static final double YAW_DEGREES = 60;
    private static final double LEVEL_DEGREES = -17;
    private static final double PITCH_DEGREES = 20;
    private static final double MAX_DEGREES_PER_SECOND = 180;

    private final Motors motors;
    private int cycle;

    /**
     * Creates a head scan.
     *
     * @param motors the robot's motors
     */
    public LookAround(Motors motors) {
        this.motors = motors;
    }

    /** Advances the scan by one cycle. Call this method in each cycle in which the head should move. */
    public void look() {
        double phase = 2 * Math.PI * cycle * Cycle.SECONDS / ROUND_SECONDS;
        cycle++;
        motors.setTarget(Joint.NECK_YAW, YAW_DEGREES * PortableMath.sin(phase), MAX_DEGREES_PER_SECOND);
        double pitch = LEVEL_DEGREES - PITCH_DEGREES * PortableMath.cos(phase);
        motors.setTarget(Joint.NECK_PITCH, pitch, MAX_DEGREES_PER_SECOND);
    }
}
