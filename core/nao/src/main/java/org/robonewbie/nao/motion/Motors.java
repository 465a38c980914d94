package org.robonewbie.nao.motion;

import java.util.Arrays;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * Speed controller for the motors of the 22 joints. The simulator accepts speeds only: a motor keeps its speed until it
 * receives another one. This class adds target angles, which a joint approaches and holds, and stops joints just before
 * they reach their mechanical stops.
 *
 * <p>It compensates for the delay of the simulation. The speed sent in response to message k turns the joint in the
 * step before message k + 2. Until then the speed sent in response to message k - 1 is still in effect, so when the new
 * speed takes effect, the joint will be at its sensed angle plus one step at that earlier speed: {@link
 * #expectedDegrees}.
 */
public final class Motors {

    /**
     * Distance from the mechanical stop, in degrees, at which a joint is stopped; at the stop itself, simulators ignore
     * commands.
     */
    private static final double MARGIN_DEGREES = 0.1;

    private static final Joint[] JOINTS = Joint.values();
    private static final double NO_TARGET = Double.NaN;

    private final JointStates joints;
    private final double[] sentDegreesPerSecond = new double[Joint.COUNT];
    private final double[] degreesPerSecond = new double[Joint.COUNT];
    private final double[] targetDegrees = new double[Joint.COUNT];
    private final double[] targetDegreesPerSecond = new double[Joint.COUNT];
    private final boolean[] commanded = new boolean[Joint.COUNT];
    private final boolean[] commandedNow = new boolean[Joint.COUNT];
    private final boolean[] needsCommand = new boolean[Joint.COUNT];
    private final boolean[] stopped = new boolean[Joint.COUNT];

    /**
     * Creates motors at rest.
     *
     * @param joints the sensed joint angles, to be updated with each message
     */
    public Motors(JointStates joints) {
        this.joints = joints;
        Arrays.fill(targetDegrees, NO_TARGET);
    }

    /** {@return the sensed joint angles} */
    public JointStates joints() {
        return joints;
    }

    /**
     * Returns the predicted angle of a joint at the time when a speed that is set now takes effect.
     *
     * @param joint the joint
     * @return its expected angle in degrees
     */
    public double expectedDegrees(Joint joint) {
        return joints.degrees(joint) + sentDegreesPerSecond[joint.ordinal()] * Cycle.SECONDS;
    }

    /**
     * Sets the speed of a joint, which stays in effect until the next command.
     *
     * @param joint the joint
     * @param speed speed in degrees per second, finite
     */
    public void setSpeed(Joint joint, double speed) {
        takeCommand(joint);
        targetDegrees[joint.ordinal()] = NO_TARGET;
        degreesPerSecond[joint.ordinal()] = speed;
    }

    /**
     * Moves a joint to an angle and holds it there.
     *
     * @param joint the joint
     * @param target target angle in degrees, finite
     * @param speed maximum speed in degrees per second, above 0
     */
    public void setTarget(Joint joint, double target, double speed) {
        takeCommand(joint);
        targetDegrees[joint.ordinal()] = inside(joint, target);
        targetDegreesPerSecond[joint.ordinal()] = speed;
    }

    /** Releases all joints for a motion that is starting, except those that were commanded in this cycle. */
    public void release() {
        for (int i = 0; i < Joint.COUNT; i++) {
            commanded[i] = commandedNow[i];
            targetDegrees[i] = commandedNow[i] ? targetDegrees[i] : NO_TARGET;
        }
    }

    /** Returns whether a motion may turn a joint. */
    boolean isFree(Joint joint) {
        return !commanded[joint.ordinal()];
    }

    /**
     * Sets the speed of a joint on behalf of a motion, unless the program has commanded the joint since the motion
     * started.
     */
    void setMotionSpeed(Joint joint, double speed) {
        if (isFree(joint)) {
            degreesPerSecond[joint.ordinal()] = speed;
        }
    }

    /** Stops all joints that a motion controls. */
    public void stopMotion() {
        for (Joint joint : JOINTS) {
            setMotionSpeed(joint, 0);
        }
    }

    /** Calculates the speeds to be sent in this cycle. */
    public void endCycle() {
        for (Joint joint : JOINTS) {
            int i = joint.ordinal();
            if (!Double.isNaN(targetDegrees[i])) {
                double needed = (targetDegrees[i] - expectedDegrees(joint)) / Cycle.SECONDS;
                degreesPerSecond[i] = limit(needed, targetDegreesPerSecond[i]);
            }
            double possible = limit(degreesPerSecond[i], joint.maxDegreesPerSecond());
            double before = sentDegreesPerSecond[i];
            sentDegreesPerSecond[i] = keepInside(joint, possible);
            needsCommand[i] = sentDegreesPerSecond[i] != 0 || before != 0;
            stopped[i] = commanded[i] && Double.isNaN(targetDegrees[i]) && sentDegreesPerSecond[i] != possible;
        }
        Arrays.fill(commandedNow, false);
    }

    /**
     * Returns the speed of a motor.
     *
     * @param joint the joint
     * @return the speed calculated by the last {@link #endCycle}, in degrees per second
     */
    public double sentDegreesPerSecond(Joint joint) {
        return sentDegreesPerSecond[joint.ordinal()];
    }

    /** {@return a copy of the speeds calculated by the last {@link #endCycle}, in degrees per second, in the order of {@link Joint}} */
    public double[] sentDegreesPerSecond() {
        return sentDegreesPerSecond.clone();
    }

    /**
     * {@return whether the speed calculated by the last {@link #endCycle} must be sent; a motor at rest need not be stopped again}
     *
     * @param joint the joint
     */
    public boolean needsCommand(Joint joint) {
        return needsCommand[joint.ordinal()];
    }

    /**
     * Returns whether the last {@link #endCycle} reduced the speed of a joint to keep it within its range.
     *
     * @param joint the joint
     * @return whether the speed that was set would have moved the joint out of its range
     */
    public boolean isStopped(Joint joint) {
        return stopped[joint.ordinal()];
    }

    /**
     * Returns whether a speed would move a joint out of its range within one cycle.
     *
     * @param joint the joint
     * @param speed speed in degrees per second
     * @return whether the speed will be reduced
     */
    public boolean leavesRange(Joint joint, double speed) {
        return keepInside(joint, speed) != speed;
    }

    /** Returns the predicted posture at the time when speeds that are set now take effect. */
    Posture expectedPosture() {
        return Posture.of(
                Arrays.stream(JOINTS).mapToDouble(this::expectedDegrees).toArray());
    }

    /** Clamps an angle to the range in which a joint accepts commands. */
    static double inside(Joint joint, double degrees) {
        return Math.max(joint.minDegrees() + MARGIN_DEGREES, Math.min(joint.maxDegrees() - MARGIN_DEGREES, degrees));
    }

    private void takeCommand(Joint joint) {
        commanded[joint.ordinal()] = true;
        commandedNow[joint.ordinal()] = true;
    }

    private double keepInside(Joint joint, double speed) {
        double room = inside(joint, speed > 0 ? joint.maxDegrees() : joint.minDegrees()) - expectedDegrees(joint);
        return speed > 0
                ? Math.min(speed, Math.max(0, room / Cycle.SECONDS))
                : Math.max(speed, Math.min(0, room / Cycle.SECONDS));
    }

    private static double limit(double value, double max) {
        return Math.max(-max, Math.min(max, value));
    }
}
