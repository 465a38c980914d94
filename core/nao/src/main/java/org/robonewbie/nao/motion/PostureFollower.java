package org.robonewbie.nao.motion;

import java.util.function.ToDoubleFunction;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * Leads the joints along a plan of one posture for each cycle: each joint gets the speed that leads from the last planned angle
 * to the next one, and a part of the difference between plan and robot is made good as well.
 */
public final class PostureFollower {

    /** Which part of a difference between plan and robot is made good in each cycle. */
    static final double CORRECTION = 0.5;

    private static final Joint[] JOINTS = Joint.values();

    private final Motors motors;
    private final double[] plannedDegrees = new double[Joint.COUNT];

    /**
     * Begins where the robot is.
     *
     * @param motors the robot's motors
     */
    public PostureFollower(Motors motors) {
        this.motors = motors;
        takePosture();
    }

    /** Takes all joints but those that are commanded in this very cycle, and begins where they are. */
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
     * Leads the joints to the next posture of the plan.
     *
     * @param next where the joints are to be after one cycle
     */
    public void follow(Posture next) {
        follow(next::degrees, CORRECTION);
    }

    /** Leads the joints to their next angles, making good a part of the difference between plan and robot. */
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
