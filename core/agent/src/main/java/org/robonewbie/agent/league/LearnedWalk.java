package org.robonewbie.agent.league;

import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.policy.InferenceSession;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.robot.BoosterT1;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Walk of a league robot: velocity and sensor readings in, joint targets out. The legs step in a fixed rhythm, and a learned policy
 * corrects it.
 *
 * <p>The policy is learned by {@code python -m robonewbie.t1 train}. Its file contains what the training assumed: stance, gains, rhythm
 * and units; the documentation of the Python package {@code robonewbie.t1} describes the rest, and this class must compute the same.
 */
public final class LearnedWalk {

    private static final int JOINTS_PER_LEG = 6;
    private static final int OUTPUTS = 2 * JOINTS_PER_LEG;
    private static final int INPUTS = 10 + 3 * OUTPUTS;
    private static final int ACTIONS_TO_FULL_SPEED = 12;
    private static final double GRAVITY_TRUST = Cycle.SECONDS / 0.8;
    private static final double MIN_ACCELERATION = 5;
    private static final double MAX_ACCELERATION = 20;

    private final RobotModel model;
    private final InferenceSession session;
    private final int cyclesPerAction;
    private final double[] units;
    private final List<RobotJoint> legs;
    private final double[] stance;
    private final double[] stiffness;
    private final double[] damping;
    private final double[] rangeDegrees;
    private final double liftDegrees;
    private final double[] swayDegrees;
    private final double[] swingDegrees;
    private final int actionsPerStride;
    private final WalkVelocity most;
    private final double mostBackward;
    private Vector3 up = new Vector3(0, 0, 1);
    private double[] action;
    private WalkVelocity command = WalkVelocity.ZERO;
    private int cycle;
    private int phase;
    private double amplitude;

    /**
     * Loads the walk of a robot.
     *
     * @param model the robot
     * @param file path of a policy file; empty for the shipped policy
     * @return the walk; empty for a robot that only stands, because no policy is shipped for it
     * @throws IllegalArgumentException if the file contains no policy for a walk of that robot
     * @throws UncheckedIOException if the file cannot be read
     */
    public static Optional<LearnedWalk> of(RobotModel model, Optional<String> file) {
        Optional<Policy> shipped =
                model.equals(BoosterT1.MODEL) ? Optional.of(PolicyFile.shipped("t1-walk")) : Optional.empty();
        return file.map(PolicyFile::read).or(() -> shipped).map(policy -> new LearnedWalk(policy, model));
    }

    /**
     * Creates a walk.
     *
     * @throws IllegalArgumentException if the policy was trained for another robot or task
     */
    LearnedWalk(Policy policy, RobotModel model) {
        this.model = model;
        this.session = policy.network().session();
        this.cyclesPerAction = policy.cyclesPerAction();
        this.units = policy.inputs().stream().mapToDouble(Quantity::factor).toArray();
        int joints = model.joints().size();
        this.stance = policy.numbers("stance-degrees", joints);
        this.stiffness = policy.numbers("stiffness", joints);
        this.damping = policy.numbers("damping", joints);
        double[] limits = policy.numbers("most-forward-left-turn-backward", 4);
        this.most = new WalkVelocity(limits[0], limits[1], limits[2]);
        this.mostBackward = limits[3];
        this.liftDegrees = policy.numbers("lift-degrees", 1)[0];
        this.swayDegrees = policy.numbers("sway-degrees-sine-cosine-foot", 3);
        this.swingDegrees = policy.numbers("swing-degrees-forward-left-turn", 3);
        this.actionsPerStride = (int) policy.numbers("actions-per-stride", 1)[0];
        this.legs = policy.outputs().stream().map(this::jointOf).toList();
        this.rangeDegrees =
                policy.outputs().stream().mapToDouble(Quantity::factor).toArray();
        this.action = new double[legs.size()];
        if (units.length != INPUTS || legs.size() != OUTPUTS) {
            throw new IllegalArgumentException("The policy \"" + policy.task() + "\" has " + units.length
                    + " inputs and " + legs.size() + " outputs, but a walk needs " + INPUTS + " and " + OUTPUTS + ".");
        }
    }

    private RobotJoint jointOf(Quantity output) {
        return model.joint(output.name())
                .orElseThrow(() -> new IllegalArgumentException(
                        "The robot " + model.name() + " has no motor \"" + output.name() + "\"."));
    }

    /** Returns the angles of all joints from which the walk begins, in degrees. */
    double[] stance() {
        return stance.clone();
    }

    double stiffness(int joint) {
        return stiffness[joint];
    }

    double damping(int joint) {
        return damping[joint];
    }

    /**
     * Updates the estimated tilt; call this method in each cycle. The gyroscope turns the direction of up, and the accelerometer, which
     * at rest points up, corrects its drift. Its readings during impacts are ignored.
     */
    void sense(TorsoMotion torso) {
        Vector3 rate = torso.gyro().times(PortableMath.toRadians(1) * Cycle.SECONDS);
        Vector3 turned = up.plus(up.cross(rate));
        double strength = torso.acceleration().length();
        if (strength > MIN_ACCELERATION && strength < MAX_ACCELERATION) {
            Vector3 measured = torso.acceleration().times(1 / strength);
            turned = turned.plus(measured.minus(turned).times(GRAVITY_TRUST));
        }
        up = turned.times(1 / turned.length());
    }

    /** Starts to walk from the stance. */
    void begin() {
        session.reset();
        action = new double[legs.size()];
        command = WalkVelocity.ZERO;
        cycle = 0;
        phase = 0;
        amplitude = 0;
    }

    /**
     * Returns the targets of all joints for the next cycle, in degrees.
     *
     * @param wanted the wanted velocity
     * @param gyro angular velocity of the torso in degrees per second
     * @param degrees measured angles of all joints
     * @param degreesPerSecond measured speeds of all joints
     */
    double[] targets(WalkVelocity wanted, Vector3 gyro, double[] degrees, double[] degreesPerSecond) {
        if (cycle % cyclesPerAction == 0) {
            command = command.towards(
                    wanted.within(most, mostBackward),
                    new WalkVelocity(
                            most.forward() / ACTIONS_TO_FULL_SPEED,
                            most.left() / ACTIONS_TO_FULL_SPEED,
                            most.turn() / ACTIONS_TO_FULL_SPEED));
            phase = amplitude > 0 ? (phase + 1) % actionsPerStride : 0;
            double change = (command.isZero() ? -1.0 : 1.0) / actionsPerStride;
            amplitude = Math.max(0, Math.min(1, amplitude + change));
            action = session.apply(observation(gyro, degrees, degreesPerSecond));
        }
        cycle++;
        double[] targets = stance();
        for (int i = 0; i < legs.size(); i++) {
            targets[legs.get(i).index()] += rhythm(i) + rangeDegrees[i] * Math.max(-1, Math.min(1, action[i]));
        }
        return targets;
    }

    private double sine() {
        return amplitude * PortableMath.sin(2 * Math.PI * phase / actionsPerStride);
    }

    private double cosine() {
        return amplitude * PortableMath.cos(2 * Math.PI * phase / actionsPerStride);
    }

    /** Returns how far the rhythm moves a joint from the stance, in degrees. The left foot swings while the sine is positive. */
    private double rhythm(int leg) {
        double side = leg < JOINTS_PER_LEG ? 1 : -1;
        double lift = liftDegrees * Math.max(0, side * sine());
        double swing = -side * cosine();
        double forward = swing * swingDegrees[0] * command.forward() / most.forward();
        double left = swing * swingDegrees[1] * command.left() / most.left();
        double turn = swing * swingDegrees[2] * command.turn() / most.turn();
        double sway = sine() * swayDegrees[0] + cosine() * swayDegrees[1];
        return switch (leg % JOINTS_PER_LEG) {
            case 0 -> -lift - forward; // hip pitch
            case 1 -> left + sway; // hip roll
            case 2 -> turn; // hip yaw
            case 3 -> 2 * lift; // knee
            case 4 -> 0.7 * forward - lift; // foot pitch
            default -> -left - swayDegrees[2] * sway; // foot roll
        };
    }

    private double[] observation(Vector3 gyro, double[] degrees, double[] degreesPerSecond) {
        double[] values = new double[INPUTS];
        int next = 0;
        for (double value : new double[] {up.x(), up.y(), gyro.x(), gyro.y(), gyro.z()}) {
            values[next++] = value;
        }
        for (RobotJoint leg : legs) {
            values[next++] = degrees[leg.index()] - stance[leg.index()];
        }
        for (RobotJoint leg : legs) {
            values[next++] = degreesPerSecond[leg.index()];
        }
        for (double last : action) {
            values[next++] = last;
        }
        for (double value : new double[] {command.forward(), command.left(), command.turn(), sine(), cosine()}) {
            values[next++] = value;
        }
        for (int i = 0; i < INPUTS; i++) {
            values[i] /= units[i];
        }
        return values;
    }
}
