package org.robonewbie.agent.league;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.effector.LeagueMessageWriter;
import org.robonewbie.protocol.perceptor.LeaguePerception;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * The motors of a robot of the league, which are commanded by target angles. Arms and head follow the speeds of a program for the NAO;
 * all other joints stand.
 */
final class LeagueMotors {

    /** Time in which a robot that was placed on the pitch moves into its stance. */
    static final double SECONDS_TO_STANCE = 0.8;

    /** A target that runs further ahead of its joint makes the robot jerk as soon as the joint is free again. */
    private static final double MAX_LEAD_DEGREES = 10;

    private static final double ARM_STIFFNESS = 60;
    private static final double ARM_DAMPING = 1.5;

    /** More damping makes a foot in the air vibrate. */
    private static final double MAX_FOOT_DAMPING = 2;

    private final RobotModel model;
    private final List<SharedJoint> shared;
    private final StandingLegs legs;
    private final double[] degrees;
    private final double[] startDegrees;
    private final double[] targetDegrees;
    private final double[] degreesPerSecond;
    private double secondsInStance;

    LeagueMotors(RobotModel model) {
        this.model = model;
        this.shared = SharedJoint.of(model);
        this.legs = new StandingLegs(model);
        int joints = model.joints().size();
        this.degrees = new double[joints];
        this.startDegrees = new double[joints];
        this.targetDegrees = new double[joints];
        this.degreesPerSecond = new double[joints];
        moveToStance();
    }

    /** {@return the joints of arms and head, which the program can move} */
    List<SharedJoint> shared() {
        return shared;
    }

    /** Updates the measured angles. */
    void sense(LeaguePerception.Joints joints) {
        for (int i = 0; i < degrees.length; i++) {
            double measured = joints.degrees(i);
            degrees[i] = Double.isFinite(measured) ? measured : degrees[i];
        }
    }

    /** Starts to move from the present posture into the stance, with the arms as a NAO has them at 0°. */
    void moveToStance() {
        secondsInStance = 0;
        System.arraycopy(degrees, 0, startDegrees, 0, degrees.length);
        Arrays.fill(degreesPerSecond, 0);
        shared.forEach(joint -> targetDegrees[joint.index()] = joint.fromNao(0));
    }

    /**
     * Sets the speed of a motor of the NAO, which stays in effect until the next one.
     *
     * @return false if programs cannot move that joint of this robot
     */
    boolean setSpeed(String effectorName, double naoDegreesPerSecond) {
        for (SharedJoint joint : shared) {
            if (joint.joint().effectorName().equals(effectorName)) {
                degreesPerSecond[joint.index()] = joint.sign() * naoDegreesPerSecond;
                return true;
            }
        }
        return false;
    }

    /** Advances the targets by one cycle and writes them. */
    void write(LeagueMessageWriter writer) {
        secondsInStance += Cycle.SECONDS;
        double share = Math.min(1, secondsInStance / SECONDS_TO_STANCE);
        if (share == 1) {
            shared.forEach(joint -> advance(joint.index()));
        }
        double[] standing = legs.stand(shared, targetDegrees);
        for (RobotJoint joint : model.joints()) {
            int i = joint.index();
            double target = startDegrees[i] + share * (standing[i] - startDegrees[i]);
            if (isShared(i)) {
                writer.motor(i, target, share == 1 ? degreesPerSecond[i] : 0, ARM_STIFFNESS, ARM_DAMPING, 0);
            } else if (joint.motor() instanceof Motor.Torque motor) {
                double damping = joint.name().contains("Ankle") ? MAX_FOOT_DAMPING : motor.damping();
                writer.motor(i, target, 0, motor.stiffness(), damping, 0);
            }
        }
    }

    private boolean isShared(int index) {
        return shared.stream().anyMatch(joint -> joint.index() == index);
    }

    private void advance(int joint) {
        if (degreesPerSecond[joint] != 0) {
            double next = targetDegrees[joint] + degreesPerSecond[joint] * Cycle.SECONDS;
            double near = Math.max(degrees[joint] - MAX_LEAD_DEGREES, Math.min(degrees[joint] + MAX_LEAD_DEGREES, next));
            targetDegrees[joint] = model.joints().get(joint).clampDegrees(near);
        }
    }
}
