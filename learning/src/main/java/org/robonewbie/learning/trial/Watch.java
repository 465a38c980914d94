package org.robonewbie.learning.trial;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/**
 * Watches how a robot keeps on its feet and how smoothly it moves. It breaks a trial off when the robot has fallen: torso
 * tilted over 60° or its centre below 0.2 m.
 */
public final class Watch implements TrialObserver {

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
        fallen |= robot.isFallen();
        return !fallen;
    }

    /** {@return whether the robot has fallen; true from the moment of the fall} */
    public boolean hasFallen() {
        return fallen;
    }

    /** {@return how long the robot was watched, in seconds} */
    public double seconds() {
        return cycles * Cycle.SECONDS;
    }

    /** {@return the mean sine of the torso's tilt} */
    public double meanTilt() {
        return tilt / Math.max(1, cycles);
    }

    /** {@return the largest tilt of the torso in degrees} */
    public double largestTiltDegrees() {
        return Math.toDegrees(Math.acos(Math.max(-1, leastUpright)));
    }

    /** {@return the mean speed of the torso about the horizontal axes, degrees per second} */
    public double meanRocking() {
        return turning / Math.max(1, cycles);
    }

    /** {@return the mean number of joints at their speed limit} */
    public double meanJointsAtLimit() {
        return overSpeed / Math.max(1, cycles);
    }
}
