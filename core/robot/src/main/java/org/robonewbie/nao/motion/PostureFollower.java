package org.robonewbie.nao.motion;

import java.util.function.IntToDoubleFunction;
import org.robonewbie.nao.Cycle;

/**
 * Trajectory follower for a plan of one posture per cycle. Each joint is given the speed that leads from the last
 * planned angle to the next one (feedforward), plus a correction of the tracking error (feedback).
 */
public final class PostureFollower {

    /** Fraction of the tracking error that is corrected in each cycle. */
    static final double CORRECTION = 0.5;

    private final Motors motors;
    private final double[] plannedDegrees;

    /**
     * Creates a follower that starts at the robot's current posture.
     *
     * @param motors the robot's motors
     */
    public PostureFollower(Motors motors) {
        this.motors = motors;
        plannedDegrees = new double[motors.joints().jointSpace().size()];
        takePosture();
    }

    /**
     * Restarts at the robot's current posture, and takes control of all joints except those commanded in this cycle.
     */
    public void begin() {
        motors.release();
        takePosture();
    }

    private void takePosture() {
        for (int i = 0; i < plannedDegrees.length; i++) {
            plannedDegrees[i] = motors.expectedDegrees(i);
        }
    }

    /**
     * Sets the speeds that lead to the next posture of the plan.
     *
     * @param next the planned posture after one cycle
     */
    public void follow(Posture next) {
        follow(next::degrees, CORRECTION);
    }

    /** Sets the speeds that lead to the next planned angles and correct a fraction of the tracking error. */
    void follow(IntToDoubleFunction next, double correction) {
        for (int i = 0; i < plannedDegrees.length; i++) {
            follow(i, next.applyAsDouble(i), correction);
        }
    }

    private void follow(int joint, double next, double correction) {
        double angle = motors.inside(joint, next);
        double error = plannedDegrees[joint] - motors.expectedDegrees(joint);
        motors.setMotionSpeed(joint, (angle - plannedDegrees[joint] + correction * error) / Cycle.SECONDS);
        plannedDegrees[joint] = angle;
    }
}
