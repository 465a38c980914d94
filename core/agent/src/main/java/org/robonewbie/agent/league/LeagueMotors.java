package org.robonewbie.agent.league;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.walk.Locomotion;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.effector.LeagueMessageWriter;
import org.robonewbie.protocol.perceptor.LeaguePerception;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * The motors of a league robot, which are commanded by target angles. Arms and head follow the speeds of a program for the NAO; the legs
 * stand or walk. While the robot walks, its arms hang down, as in the training of the walk.
 */
final class LeagueMotors implements Locomotion {

    /** Time in which a robot that was placed on the pitch moves into its stance. */
    static final double SECONDS_TO_STANCE = 0.8;

    private static final double SECONDS_TO_CHANGE = 0.5;
    private static final double SECONDS_TO_STOP = 1;

    /** A target that runs further ahead of its joint makes the robot jerk as soon as the joint is free again. */
    private static final double MAX_LEAD_DEGREES = 10;

    /** A joint turned this far, and in the next cycle all joints near 0°, can only mean that the server has set the joints. */
    private static final double BENT_DEGREES = 30;

    private static final double STRAIGHT_DEGREES = 10;

    private static final double ARM_STIFFNESS = 60;
    private static final double ARM_DAMPING = 1.5;

    /** More damping makes a foot in the air vibrate. */
    private static final double FOOT_DAMPING = 2;

    private final RobotModel model;
    private final Diagnostics diagnostics;
    private final List<SharedJoint> shared;
    private final StandingLegs legs;
    private final Optional<LearnedWalk> walk;
    private final double[] degrees;
    private final double[] measuredDegreesPerSecond;
    private final double[] startDegrees;
    private final double[] armDegrees;
    private final double[] degreesPerSecond;
    private final double[] sentDegrees;
    private final double[] stiffness;
    private final double[] damping;
    private TorsoMotion torso = TorsoMotion.AT_REST;
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private boolean walking;
    private boolean fallen;
    private double changeSeconds;
    private double secondsOfChange;
    private double secondsStopped;

    /**
     * Creates motors at rest.
     *
     * @param walk the robot's walk; empty for a robot that only stands
     * @param diagnostics receives reports about velocities that the robot cannot walk with
     */
    LeagueMotors(RobotModel model, Optional<LearnedWalk> walk, Diagnostics diagnostics) {
        this.model = model;
        this.diagnostics = diagnostics;
        this.walk = walk;
        this.shared = SharedJoint.of(model);
        this.legs = new StandingLegs(model);
        int joints = model.joints().size();
        this.degrees = new double[joints];
        this.measuredDegreesPerSecond = new double[joints];
        this.startDegrees = new double[joints];
        this.armDegrees = new double[joints];
        this.degreesPerSecond = new double[joints];
        this.sentDegrees = new double[joints];
        this.stiffness = new double[joints];
        this.damping = new double[joints];
        setGainsOfStance();
        placed();
    }

    private void setGainsOfStance() {
        for (RobotJoint joint : model.joints()) {
            if (joint.motor() instanceof Motor.Torque motor) {
                stiffness[joint.index()] = motor.stiffness();
                damping[joint.index()] = joint.name().contains("Ankle") ? FOOT_DAMPING : motor.damping();
            }
        }
        for (SharedJoint joint : shared) {
            stiffness[joint.index()] = ARM_STIFFNESS;
            damping[joint.index()] = ARM_DAMPING;
        }
    }

    /** {@return the joints of arms and head, which the program can move} */
    List<SharedJoint> shared() {
        return shared;
    }

    /**
     * Updates the measured values.
     *
     * @return whether the referee or a beam has placed the robot, which then stands on straight legs
     */
    boolean sense(LeaguePerception.Joints joints, TorsoMotion newTorso) {
        double before = largestDegrees();
        for (int i = 0; i < degrees.length; i++) {
            degrees[i] = finite(joints.degrees(i), degrees[i]);
            measuredDegreesPerSecond[i] = finite(joints.degreesPerSecond(i), measuredDegreesPerSecond[i]);
        }
        torso = newTorso;
        walk.ifPresent(learned -> learned.sense(newTorso));
        boolean isPlaced = before > BENT_DEGREES && largestDegrees() < STRAIGHT_DEGREES;
        if (isPlaced) {
            placed();
        }
        return isPlaced;
    }

    private double largestDegrees() {
        return Arrays.stream(degrees).map(Math::abs).max().orElse(0);
    }

    /**
     * Sets whether the robot is lying on the ground. It then stretches, so that the referee recognises that it lies, and ignores all
     * commands until it is placed on its feet.
     */
    void setFallen(boolean lying) {
        if (lying && !fallen) {
            fallen = true;
            diagnostics.reportAt(
                    "",
                    "league fall",
                    () -> "The " + model.name() + " has fallen and cannot get up: it waits until the referee puts it"
                            + " beside the pitch, after 15 s (30 s for number 1).");
            stop();
            change(sentDegrees, SECONDS_TO_CHANGE);
        } else if (!lying && fallen) {
            placed();
        }
    }

    private void stop() {
        walking = false;
        wanted = WalkVelocity.ZERO;
        Arrays.fill(degreesPerSecond, 0);
    }

    /** Starts to move into the stance, with the arms as a NAO has them at 0°. The server has set all joints to 0°. */
    void placed() {
        fallen = false;
        stop();
        shared.forEach(joint -> armDegrees[joint.index()] = joint.fromNao(0));
        change(new double[degrees.length], SECONDS_TO_STANCE);
    }

    /** Starts a smooth change from given angles to those that {@link #targets} returns. */
    private void change(double[] from, double seconds) {
        System.arraycopy(from, 0, startDegrees, 0, from.length);
        secondsOfChange = seconds;
        changeSeconds = 0;
    }

    @Override
    public void towards(WalkVelocity velocity) {
        if (fallen) {
            return;
        }
        if (walk.isEmpty() && !velocity.isZero()) {
            diagnostics.reportAt("", "league walk", () -> "The " + model.name() + " cannot walk yet; it only stands.");
        }
        if (velocity.left() != 0) {
            diagnostics.reportAt(
                    "",
                    "league walk left",
                    () -> "The " + model.name() + " cannot walk sideways yet: turn it and walk ahead.");
        }
        wanted = new WalkVelocity(velocity.forward(), 0, velocity.turn());
    }

    @Override
    public boolean isWalking() {
        return walking && secondsStopped < SECONDS_TO_STOP;
    }

    /**
     * Sets the speed of a motor of the NAO, which stays in effect until the next one.
     *
     * @return false if programs cannot move that joint of this robot; a fallen robot ignores all commands
     */
    boolean setSpeed(String effectorName, double naoDegreesPerSecond) {
        if (fallen) {
            return true;
        }
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
        secondsStopped = wanted.isZero() ? secondsStopped + Cycle.SECONDS : 0;
        changeLegs();
        changeSeconds += Cycle.SECONDS;
        double share = Math.min(1, changeSeconds / secondsOfChange);
        shared.forEach(joint -> advance(joint, share));
        double[] targets = targets(share);
        for (int i = 0; i < targets.length; i++) {
            sentDegrees[i] = startDegrees[i] + share * (targets[i] - startDegrees[i]);
            if (walking) {
                LearnedWalk learned = walk.orElseThrow();
                writer.motor(i, sentDegrees[i], 0, learned.stiffness(i), learned.damping(i), 0);
            } else {
                writer.motor(i, sentDegrees[i], degreesPerSecond[i], stiffness[i], damping[i], 0);
            }
        }
    }

    /** Changes from standing to walking if a velocity is wanted, and back as soon as the program moves an arm after the robot stopped. */
    private void changeLegs() {
        boolean starts = !walking && !wanted.isZero() && walk.isPresent() && changeSeconds >= secondsOfChange;
        boolean ends = walking && secondsStopped >= SECONDS_TO_STOP && isArmMoving();
        if (starts) {
            walk.get().begin();
        } else if (ends) {
            shared.stream().filter(SharedJoint::isArm).forEach(arm -> armDegrees[arm.index()] = degrees[arm.index()]);
        }
        if (starts || ends) {
            walking = starts;
            change(sentDegrees, SECONDS_TO_CHANGE);
        }
    }

    private boolean isArmMoving() {
        return shared.stream().anyMatch(joint -> joint.isArm() && degreesPerSecond[joint.index()] != 0);
    }

    private void advance(SharedJoint joint, double share) {
        int i = joint.index();
        if (degreesPerSecond[i] != 0 && (!joint.isArm() || (share == 1 && !walking))) {
            double next = armDegrees[i] + degreesPerSecond[i] * Cycle.SECONDS;
            double near = Math.max(degrees[i] - MAX_LEAD_DEGREES, Math.min(degrees[i] + MAX_LEAD_DEGREES, next));
            armDegrees[i] = model.joints().get(i).clampDegrees(near);
        }
    }

    private double[] targets(double share) {
        if (fallen) {
            return new double[degrees.length];
        }
        if (!walking) {
            return legs.stand(shared, armDegrees);
        }
        LearnedWalk learned = walk.orElseThrow();
        double[] targets =
                share < 1 ? learned.stance() : learned.targets(wanted, torso.gyro(), degrees, measuredDegreesPerSecond);
        shared.stream()
                .filter(joint -> !joint.isArm())
                .forEach(head -> targets[head.index()] = armDegrees[head.index()]);
        return targets;
    }

    private static double finite(double value, double otherwise) {
        return Double.isFinite(value) ? value : otherwise;
    }
}
