package org.robonewbie.nao.motion;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * Speed controller for the motors of a robot. The simulator accepts speeds only: a motor keeps its speed until it
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

    private static final double NO_TARGET = Double.NaN;

    private final JointStates joints;
    private final List<JointSpace.Limits> limits;
    private final double[] sentDegreesPerSecond;
    private final double[] degreesPerSecond;
    private final double[] targetDegrees;
    private final double[] targetDegreesPerSecond;
    private final boolean[] commanded;
    private final boolean[] commandedNow;
    private final boolean[] needsCommand;
    private final boolean[] stopped;

    /**
     * Creates motors at rest.
     *
     * @param joints the sensed joint angles, to be updated with each message
     */
    public Motors(JointStates joints) {
        this.joints = joints;
        limits = joints.jointSpace().joints();
        sentDegreesPerSecond = new double[limits.size()];
        degreesPerSecond = new double[limits.size()];
        targetDegrees = new double[limits.size()];
        targetDegreesPerSecond = new double[limits.size()];
        commanded = new boolean[limits.size()];
        commandedNow = new boolean[limits.size()];
        needsCommand = new boolean[limits.size()];
        stopped = new boolean[limits.size()];
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
        return expectedDegrees(joint.ordinal());
    }

    double expectedDegrees(int joint) {
        return joints.degrees(joint) + sentDegreesPerSecond[joint] * Cycle.SECONDS;
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
        targetDegrees[joint.ordinal()] = inside(joint.ordinal(), target);
        targetDegreesPerSecond[joint.ordinal()] = speed;
    }

    /** Releases all joints for a motion that is starting, except those that were commanded in this cycle. */
    public void release() {
        for (int i = 0; i < commanded.length; i++) {
            commanded[i] = commandedNow[i];
            targetDegrees[i] = commandedNow[i] ? targetDegrees[i] : NO_TARGET;
        }
    }

    /** Returns whether a motion may turn a joint. */
    boolean isFree(int joint) {
        return !commanded[joint];
    }

    /**
     * Sets the speed of a joint on behalf of a motion, unless the program has commanded the joint since the motion
     * started.
     */
    void setMotionSpeed(int joint, double speed) {
        if (isFree(joint)) {
            degreesPerSecond[joint] = speed;
        }
    }

    /** Stops all joints that a motion controls. */
    public void stopMotion() {
        for (int i = 0; i < limits.size(); i++) {
            setMotionSpeed(i, 0);
        }
    }

    /** Calculates the speeds to be sent in this cycle. */
    public void endCycle() {
        for (int i = 0; i < limits.size(); i++) {
            if (!Double.isNaN(targetDegrees[i])) {
                double needed = (targetDegrees[i] - expectedDegrees(i)) / Cycle.SECONDS;
                degreesPerSecond[i] = limit(needed, targetDegreesPerSecond[i]);
            }
            double possible = limit(degreesPerSecond[i], limits.get(i).maxDegreesPerSecond());
            double before = sentDegreesPerSecond[i];
            sentDegreesPerSecond[i] = keepInside(i, possible);
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

    /** {@return a copy of the speeds calculated by the last {@link #endCycle}, in degrees per second, in the order of the joints} */
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
        return keepInside(joint.ordinal(), speed) != speed;
    }

    /** Returns the predicted posture at the time when speeds that are set now take effect. */
    Posture expectedPosture() {
        return Posture.of(
                joints.jointSpace(),
                IntStream.range(0, limits.size())
                        .mapToDouble(this::expectedDegrees)
                        .toArray());
    }

    /** Clamps an angle to the range in which a joint accepts commands. */
    double inside(int joint, double degrees) {
        JointSpace.Limits range = limits.get(joint);
        return Math.max(range.minDegrees() + MARGIN_DEGREES, Math.min(range.maxDegrees() - MARGIN_DEGREES, degrees));
    }

    private void takeCommand(Joint joint) {
        commanded[joint.ordinal()] = true;
        commandedNow[joint.ordinal()] = true;
    }

    private double keepInside(int joint, double speed) {
        JointSpace.Limits range = limits.get(joint);
        double room = inside(joint, speed > 0 ? range.maxDegrees() : range.minDegrees()) - expectedDegrees(joint);
        return speed > 0
                ? Math.min(speed, Math.max(0, room / Cycle.SECONDS))
                : Math.max(speed, Math.min(0, room / Cycle.SECONDS));
    }

    private static double limit(double value, double max) {
        return Math.max(-max, Math.min(max, value));
    }
}
