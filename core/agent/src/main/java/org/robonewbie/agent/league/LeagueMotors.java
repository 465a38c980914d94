package org.robonewbie.agent.league;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.agent.cycle.OwnJoints;
import org.robonewbie.agent.log.Diagnostics;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.walk.Locomotion;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.T1Joint;
import org.robonewbie.protocol.effector.LeagueMessageWriter;
import org.robonewbie.protocol.perceptor.LeaguePerception;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * The motors of a league robot, which are commanded by target angles. Arms and head follow the speeds of a program for the NAO; the legs
 * stand or walk. While the robot walks, its arms hang down, as in the training of the walk.
 */
final class LeagueMotors implements Locomotion, OwnJoints {

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
    /** Targets that the program has set for joints by their own names; NaN for none. */
    private final double[] ownDegrees;

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
        this.ownDegrees = new double[joints];
        placed();
    }

    /** Leaves a joint to the stance and to the speeds for a NAO's joint. */
    private void release(int index) {
        RobotJoint joint = model.joints().get(index);
        ownDegrees[index] = Double.NaN;
        if (shared(index).isPresent()) {
            stiffness[index] = ARM_STIFFNESS;
            damping[index] = ARM_DAMPING;
        } else if (joint.motor() instanceof Motor.Torque motor) {
            stiffness[index] = motor.stiffness();
            damping[index] = joint.name().contains("Ankle") ? FOOT_DAMPING : motor.damping();
        }
    }

    private void releaseAll() {
        for (int i = 0; i < ownDegrees.length; i++) {
            release(i);
        }
    }

    private Optional<SharedJoint> shared(int index) {
        return shared.stream().filter(joint -> joint.index() == index).findFirst();
    }

    private boolean isHead(int index) {
        return shared(index).filter(joint -> !joint.isArm()).isPresent();
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
        releaseAll();
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
        wanted = velocity;
    }

    @Override
    public double degrees(T1Joint joint) {
        return degrees[joint.ordinal()];
    }

    @Override
    public void setTarget(T1Joint joint, double target) {
        if (obeys(joint)) {
            release(joint.ordinal());
            hold(joint.ordinal(), target);
        }
    }

    @Override
    public void setTarget(T1Joint joint, double target, double newStiffness, double newDamping) {
        if (obeys(joint)) {
            stiffness[joint.ordinal()] = newStiffness;
            damping[joint.ordinal()] = newDamping;
            hold(joint.ordinal(), target);
        }
    }

    private void hold(int index, double target) {
        ownDegrees[index] = target;
        degreesPerSecond[index] = 0;
        armDegrees[index] = target;
    }

    /** Returns whether a joint follows the program: not on the ground and, but for the head, not while the robot walks. */
    private boolean obeys(T1Joint joint) {
        boolean isHead = isHead(joint.ordinal());
        if (isWalking() && !isHead) {
            diagnostics.reportAt(
                    "",
                    "league walk joint",
                    () -> "While the " + model.name() + " walks, only its head obeys: the target for " + joint
                            + " is ignored.");
        }
        return !fallen && (isHead || !isWalking());
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
                release(joint.index());
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
            boolean isOwn = !walking && !Double.isNaN(ownDegrees[i]);
            sentDegrees[i] = isOwn ? ownDegrees[i] : startDegrees[i] + share * (targets[i] - startDegrees[i]);
            if (walking) {
                LearnedWalk learned = walk.orElseThrow();
                writer.motor(i, sentDegrees[i], 0, learned.stiffness(i), learned.damping(i), 0);
            } else {
                writer.motor(i, sentDegrees[i], degreesPerSecond[i], stiffness[i], damping[i], 0);
            }
        }
    }

    /** Changes from standing to walking if a velocity is wanted, and back as soon as the program moves a joint after the robot stopped. */
    private void changeLegs() {
        boolean starts = !walking && !wanted.isZero() && walk.isPresent() && changeSeconds >= secondsOfChange;
        boolean ends = walking && secondsStopped >= SECONDS_TO_STOP && isJointWanted();
        if (starts) {
            releaseAll();
            walk.get().begin();
        } else if (ends) {
            shared.stream()
                    .filter(joint -> joint.isArm() && Double.isNaN(ownDegrees[joint.index()]))
                    .forEach(arm -> armDegrees[arm.index()] = degrees[arm.index()]);
        }
        if (starts || ends) {
            walking = starts;
            change(sentDegrees, SECONDS_TO_CHANGE);
        }
    }

    private boolean isJointWanted() {
        return IntStream.range(0, ownDegrees.length)
                .anyMatch(i -> !isHead(i) && (degreesPerSecond[i] != 0 || !Double.isNaN(ownDegrees[i])));
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
