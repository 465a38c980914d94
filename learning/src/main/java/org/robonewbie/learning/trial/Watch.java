package org.robonewbie.learning.trial;

import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * Watches how a robot keeps on its feet and how smoothly it moves. It breaks a trial off when the robot has fallen: torso
 * tilted over 60° or its centre below 0.2 m.
 */
public final class Watch implements TrialObserver {

    /** Cosine of the tilt at which a robot counts as fallen. */
    public static final double FALLEN = 0.5;

    private static final double LOWEST_TORSO = 0.2;

    private int cycles;
    private boolean fallen;
    private double tilt;
    private double turning;
    private double leastUpright = 1;
    private double overSpeed;

    /** Begins to watch. */
    public Watch() {}

    @Override
    public boolean goOn(TrialRobot robot) {
        cycles++;
        double upright = robot.uprightness();
        leastUpright = Math.min(leastUpright, upright);
        tilt += Math.sqrt(Math.max(0, 1 - upright * upright));
        Vector3 rate = robot.turning();
        turning += Math.hypot(rate.x(), rate.y());
        for (Joint joint : Joint.values()) {
            if (Math.abs(robot.commandedDegreesPerSecond(joint)) >= joint.maxDegreesPerSecond() - 1e-6) {
                overSpeed++;
            }
        }
        fallen |= upright < FALLEN || robot.torso().z() < LOWEST_TORSO;
        return !fallen;
    }

    /**
     * Tells whether the robot has fallen.
     *
     * @return true from the moment of the fall
     */
    public boolean hasFallen() {
        return fallen;
    }

    /**
     * Tells how long the robot was watched.
     *
     * @return seconds
     */
    public double seconds() {
        return cycles * 0.02;
    }

    /**
     * Tells how much the torso leaned to any side.
     *
     * @return mean sine of the tilt
     */
    public double meanTilt() {
        return tilt / Math.max(1, cycles);
    }

    /**
     * Tells how much the torso leaned in the worst moment.
     *
     * @return degrees
     */
    public double largestTiltDegrees() {
        return Math.toDegrees(Math.acos(Math.max(-1, leastUpright)));
    }

    /**
     * Tells how quickly the torso rocked.
     *
     * @return mean of its speed about the horizontal axes, degrees per second
     */
    public double meanRocking() {
        return turning / Math.max(1, cycles);
    }

    /**
     * Tells how often motors were asked for all they can do.
     *
     * @return mean number of joints at their speed limit
     */
    public double meanJointsAtLimit() {
        return overSpeed / Math.max(1, cycles);
    }
}
