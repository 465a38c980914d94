package org.robonewbie.nao.motion;

import java.util.function.ToDoubleFunction;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * Trajectory follower for a plan of one posture per cycle. Each joint is given the speed that leads from the last
 * planned angle to the next one (feedforward), plus a correction of the tracking error (feedback).
 */
public final class PostureFollower {

    /** Fraction of the tracking error that is corrected in each cycle. */
    static final double CORRECTION = 0.5;

    private static final Joint[] JOINTS = Joint.values();

    private final Motors motors;
    private final double[] plannedDegrees = new double[Joint.COUNT];

    /**
     * Creates a follower that starts at the robot's current posture.
     *
     * @param motors the robot's motors
     */
    public PostureFollower(Motors motors) {
        this.motors = motors;
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
        for (Joint joint : JOINTS) {
            plannedDegrees[joint.ordinal()] = motors.expectedDegrees(joint);
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
    void follow(ToDoubleFunction<Joint> next, double correction) {
        for (Joint joint : JOINTS) {
            follow(joint, next.applyAsDouble(joint), correction);
        }
    }

    private void follow(Joint joint, double next, double correction) {
        int i = joint.ordinal();
        double angle = Motors.inside(joint, next);
        double error = plannedDegrees[i] - motors.expectedDegrees(joint);
        motors.setMotionSpeed(joint, (angle - plannedDegrees[i] + correction * error) / Cycle.SECONDS);
        plannedDegrees[i] = angle;
    }
}
