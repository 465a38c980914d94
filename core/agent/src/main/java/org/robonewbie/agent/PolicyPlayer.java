package org.robonewbie.agent;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * Does what was learned in a task of {@code robonewbie learn} or the Python package, from the robot's messages alone: joints go to
 * the first posture, or to that of the motion that the policy carries, moved by what the network says. What it says lasts as many
 * cycles as it did while the policy was learned.
 *
 * <pre>{@code
 * private final PolicyPlayer kick = new PolicyPlayer(PolicyFile.shipped("kick-to"));
 *
 * @Override
 * protected void think() {
 *     kick.setCommand("distance", 3);       // metres
 *     if (!kick.isFinished()) {
 *         kick.act(nao);                    // the robot stands in the stance behind the ball at first
 *     }
 * }
 * }</pre>
 */
public final class PolicyPlayer {

    private static final String JOINT = "joint.";
    private static final String COMMAND = "command.";
    private static final String RANGE = "range-degrees";

    private final Network network;
    private final List<ToDoubleFunction<Robot>> inputs;
    private final List<Joint> joints;
    private final double rangeDegrees;
    private final int cyclesPerAction;
    private final Optional<Motion> motion;
    private final Map<String, Double> commands = new TreeMap<>();
    private Optional<MotionGuide> guide = Optional.empty();
    private double[] progress = {};
    private Posture first = Posture.ZERO;
    private double[] action = {};
    private boolean acting;
    private int cycles;

    /**
     * Takes a policy.
     *
     * @param policy what was learned by {@code robonewbie learn} or {@code python -m robonewbie.train}
     * @throws IllegalArgumentException if it takes what a robot does not feel, or moves what is no joint
     */
    public PolicyPlayer(Policy policy) {
        network = policy.network();
        motion = Optional.ofNullable(policy.numbers().get(MotionGuide.MOTION))
                .map(numbers -> MotionGuide.motion(
                        policy.task(),
                        numbers.stream().mapToDouble(Double::doubleValue).toArray()));
        inputs = policy.inputs().stream().map(this::reading).toList();
        joints = policy.outputs().stream().map(PolicyPlayer::joint).toList();
        rangeDegrees = policy.numbers(RANGE, 1)[0];
        cyclesPerAction = policy.cyclesPerAction();
    }

    private ToDoubleFunction<Robot> reading(Quantity input) {
        int part = MotionGuide.PROGRESS.indexOf(input);
        if (part >= 0 && motion.isPresent()) {
            return robot -> progress[part];
        }
        if (input.name().startsWith(COMMAND)) {
            String command = input.name().substring(COMMAND.length());
            commands.put(command, 0.0);
            return robot -> commands.getOrDefault(command, 0.0);
        }
        return SensedQuantity.of(input).reading();
    }

    private static Joint joint(Quantity output) {
        return Arrays.stream(Joint.values())
                .filter(joint -> output.name().equals(JOINT + joint))
                .findAny()
                .orElseThrow(() -> new IllegalArgumentException("The policy moves " + output.name()
                        + ", which is no joint. Outputs are called joint.LEFT_KNEE_PITCH and the like."));
    }

    /**
     * Sets what is wanted.
     *
     * @param name what the policy can be told, such as {@code distance} of a kick
     * @param value how much, in the unit with which it was learned; 0 until it is told
     * @throws IllegalArgumentException if the policy cannot be told this
     */
    public void setCommand(String name, double value) {
        if (!commands.containsKey(name)) {
            throw new IllegalArgumentException("This policy cannot be told \"" + name + "\". It can be told: "
                    + (commands.isEmpty() ? "nothing" : String.join(", ", commands.keySet())) + ".");
        }
        commands.put(name, value);
    }

    /** Begins again with the posture that the robot has in the next cycle. */
    public void begin() {
        acting = false;
    }

    /** {@return whether the motion that the policy carries is over; a policy without a motion never is} */
    public boolean isFinished() {
        return acting && guide.isPresent() && guide.get().isOver(cycles);
    }

    /**
     * Moves the joints, to be called once in each cycle.
     *
     * @param robot feels and moves
     */
    public void act(Robot robot) {
        if (!acting) {
            first = posture(robot);
            guide = motion.map(one -> new MotionGuide(one, first));
            acting = true;
            cycles = 0;
        }
        if (cycles % cyclesPerAction == 0) {
            guide.ifPresent(one -> progress = one.progress(cycles));
            action = network.apply(inputs.stream()
                    .mapToDouble(input -> input.applyAsDouble(robot))
                    .toArray());
        }
        move(robot, action);
        cycles++;
    }

    private void move(Robot robot, double... wanted) {
        double[] degrees =
                guide.map(one -> one.posture(cycles + 1)).orElse(first).toArray();
        for (int i = 0; i < wanted.length; i++) {
            degrees[joints.get(i).ordinal()] += rangeDegrees * wanted[i];
        }
        for (Joint joint : guide.isPresent() ? List.of(Joint.values()) : joints) {
            robot.setJointAngle(joint, joint.clampDegrees(degrees[joint.ordinal()]));
        }
    }

    private static Posture posture(Robot robot) {
        return Posture.of(
                Arrays.stream(Joint.values()).mapToDouble(robot::getJointAngle).toArray());
    }
}
