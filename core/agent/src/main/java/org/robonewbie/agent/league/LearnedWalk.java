package org.robonewbie.agent.league;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Walk of a league robot by a learned policy: velocity and sensor readings in, joint targets out. The policy file contains all that the
 * training assumed: stance, gains, units of inputs and outputs, and the rhythm of the steps. It is learned by {@code python -m
 * robonewbie.t1 train}, whose module {@code robot.py} describes the inputs.
 */
final class LearnedWalk {

    private static final double OBSERVATION_LIMIT = 5;
    private static final double GRAVITY_TRUST = Cycle.SECONDS / 0.8;
    private static final double MIN_ACCELERATION = 5;
    private static final double MAX_ACCELERATION = 20;

    private final RobotModel model;
    private final Policy policy;
    private final List<RobotJoint> legs;
    private final double[] stance;
    private final double[] stiffness;
    private final double[] damping;
    private final double[] limits;
    private final double[] rangeDegrees;
    private final int cyclesPerStride;
    private Vector3 up = new Vector3(0, 0, 1);
    private double[] action;
    private WalkVelocity command = WalkVelocity.ZERO;
    private int cycle;
    private int strideCycle;

    /**
     * Creates a walk.
     *
     * @throws IllegalArgumentException if the policy was trained for another robot or task
     */
    LearnedWalk(Policy policy, RobotModel model) {
        this.model = model;
        this.policy = policy;
        int joints = model.joints().size();
        this.stance = policy.numbers("stance-degrees", joints);
        this.stiffness = policy.numbers("stiffness", joints);
        this.damping = policy.numbers("damping", joints);
        this.limits = policy.numbers("most-forward-left-turn-backward", 4);
        this.cyclesPerStride = (int) policy.numbers("actions-per-stride", 1)[0] * policy.cyclesPerAction();
        this.legs = policy.outputs().stream().map(this::jointOf).toList();
        this.rangeDegrees =
                policy.outputs().stream().mapToDouble(LearnedWalk::factor).toArray();
        this.action = new double[legs.size()];
        if (policy.inputs().size() != 10 + 3 * legs.size()) {
            throw new IllegalArgumentException("The policy \"" + policy.task() + "\" has "
                    + policy.inputs().size() + " inputs, but a walk needs " + (10 + 3 * legs.size()) + ".");
        }
    }

    private RobotJoint jointOf(Quantity output) {
        return model.joint(output.name())
                .orElseThrow(() -> new IllegalArgumentException(
                        "The robot " + model.name() + " has no motor \"" + output.name() + "\"."));
    }

    /** Returns the factor in a unit such as {@code 25 degrees}. */
    private static double factor(Quantity quantity) {
        return Double.parseDouble(quantity.unit().split(" ", 2)[0]);
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
        action = new double[legs.size()];
        command = WalkVelocity.ZERO;
        cycle = 0;
        strideCycle = 0;
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
        if (cycle % policy.cyclesPerAction() == 0) {
            boolean continues = !wanted.isZero() && !command.isZero();
            strideCycle = continues ? (strideCycle + policy.cyclesPerAction()) % cyclesPerStride : 0;
            command = wanted.within(new WalkVelocity(limits[0], limits[1], limits[2]), limits[3]);
            action = policy.network().apply(observation(gyro, degrees, degreesPerSecond));
        }
        cycle++;
        double[] targets = stance();
        for (int i = 0; i < legs.size(); i++) {
            targets[legs.get(i).index()] += rangeDegrees[i] * Math.max(-1, Math.min(1, action[i]));
        }
        return targets;
    }

    private double[] observation(Vector3 gyro, double[] degrees, double[] degreesPerSecond) {
        double[] inputs = new double[policy.inputs().size()];
        int next = 0;
        for (double value : new double[] {up.x() / 0.3, up.y() / 0.3, gyro.x() / 100, gyro.y() / 100, gyro.z() / 100}) {
            inputs[next++] = value;
        }
        for (RobotJoint leg : legs) {
            inputs[next++] = (degrees[leg.index()] - stance[leg.index()]) / 30;
        }
        for (RobotJoint leg : legs) {
            inputs[next++] = degreesPerSecond[leg.index()] / 150;
        }
        for (double last : action) {
            inputs[next++] = last;
        }
        double phase = 2 * Math.PI * strideCycle / cyclesPerStride;
        double moving = command.isZero() ? 0 : 1;
        inputs[next++] = command.forward() / limits[0];
        inputs[next++] = command.left() / limits[1];
        inputs[next++] = command.turn() / limits[2];
        inputs[next++] = moving * PortableMath.sin(phase);
        inputs[next] = moving * PortableMath.cos(phase);
        return Arrays.stream(inputs)
                .map(value -> Math.max(-OBSERVATION_LIMIT, Math.min(OBSERVATION_LIMIT, value)))
                .toArray();
    }
}
