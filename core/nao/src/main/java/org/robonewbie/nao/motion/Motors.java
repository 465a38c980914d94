package org.robonewbie.nao.motion;

import java.util.Arrays;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * The motors of the 22 joints. A simulator takes speeds only, so this class keeps them: a motor goes on with its speed until
 * it gets another one, a target angle is approached and held, and no joint is driven against its stop.
 *
 * <p>It knows the delay of the simulation: the speed that answers message k turns the joint in the step before message k + 2.
 * Until then the speed that answered message k - 1 still acts, so a joint will be at its sensed angle plus one step of that
 * speed when the new speed begins to act: {@link #expectedDegrees}.
 */
public final class Motors {

    /** A joint is stopped this much before its mechanical stop, where a simulator no longer listens; degrees. */
    public static final double MARGIN_DEGREES = 0.1;

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
     * Creates motors that stand still.
     *
     * @param joints where the joints are; to be updated by each message
     */
    public Motors(JointStates joints) {
        this.joints = joints;
        Arrays.fill(targetDegrees, NO_TARGET);
    }

    /** {@return where the joints are} */
    public JointStates joints() {
        return joints;
    }

    /**
     * Returns where a joint will be when a speed that is set now takes effect.
     *
     * @param joint the joint
     * @return its expected angle in degrees
     */
    public double expectedDegrees(Joint joint) {
        return joints.degrees(joint) + sentDegreesPerSecond[joint.ordinal()] * Cycle.SECONDS;
    }

    /**
     * Turns a joint from now on.
     *
     * @param joint the joint
     * @param speed in degrees per second, finite
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
     * @param target angle in degrees, finite
     * @param speed how fast it may move, in degrees per second above 0
     */
    public void setTarget(Joint joint, double target, double speed) {
        takeCommand(joint);
        targetDegrees[joint.ordinal()] = inside(joint, target);
        targetDegreesPerSecond[joint.ordinal()] = speed;
    }

    /** Hands all joints over to a motion that starts, except those that were commanded in this very cycle. */
    public void release() {
        for (int i = 0; i < Joint.COUNT; i++) {
            commanded[i] = commandedNow[i];
            targetDegrees[i] = commandedNow[i] ? targetDegrees[i] : NO_TARGET;
        }
    }

    /** Whether a motion may turn a joint. */
    boolean isFree(Joint joint) {
        return !commanded[joint.ordinal()];
    }

    /** Turns a joint by a motion, unless the joint was commanded otherwise since the motion started. */
    void setMotionSpeed(Joint joint, double speed) {
        if (isFree(joint)) {
            degreesPerSecond[joint.ordinal()] = speed;
        }
    }

    /** Stops all joints that belong to a motion. */
    public void stopMotion() {
        for (Joint joint : JOINTS) {
            setMotionSpeed(joint, 0);
        }
    }

    /** Fixes the speeds of this cycle. */
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
     * @return the speed that was fixed by the last {@link #endCycle}, in degrees per second
     */
    public double sentDegreesPerSecond(Joint joint) {
        return sentDegreesPerSecond[joint.ordinal()];
    }

    /** {@return the speeds of all joints that are sent in this cycle, in degrees per second, in the order of {@link Joint}} */
    public double[] sentDegreesPerSecond() {
        return sentDegreesPerSecond.clone();
    }

    /**
     * {@return whether the speed that was fixed by the last {@link #endCycle} has to be sent; a motor keeps its speed, so one
     * that rests need not be stopped again}
     *
     * @param joint the joint
     */
    public boolean needsCommand(Joint joint) {
        return needsCommand[joint.ordinal()];
    }

    /**
     * Returns whether a joint had to be slowed down in the last {@link #endCycle}.
     *
     * @param joint the joint
     * @return whether the speed that was set for it would have led it out of its range
     */
    public boolean isStopped(Joint joint) {
        return stopped[joint.ordinal()];
    }

    /**
     * Returns whether a joint cannot turn with a speed, since it is at the end of its range.
     *
     * @param joint the joint
     * @param speed in degrees per second
     * @return whether the joint will be stopped
     */
    public boolean leavesRange(Joint joint, double speed) {
        return keepInside(joint, speed) != speed;
    }

    /** {@return where the joints will be when speeds that are set now begin to act} */
    Posture expectedPosture() {
        return Posture.of(
                Arrays.stream(JOINTS).mapToDouble(this::expectedDegrees).toArray());
    }

    /** The nearest angle at which a joint still obeys. */
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

    private static double limit(double value, double most) {
        return Math.max(-most, Math.min(most, value));
    }
}
