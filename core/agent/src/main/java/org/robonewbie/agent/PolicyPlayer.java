package org.robonewbie.agent;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.policy.InferenceSession;
import org.robonewbie.agent.policy.MotionGuide;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.agent.walk.GaitObservation;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.Posture;

/**
 * Plays a policy that was trained by {@code robonewbie learn} or the Python package, using only the robot's sensors.
 * The network's outputs are joint speeds, or joint offsets, which are added to the posture in which the policy started, or to the
 * motion that the policy contains. Each action is held for as many cycles as in training.
 *
 * <pre>{@code
 * private final PolicyPlayer kick = new PolicyPlayer(PolicyFile.shipped("kick-to"));
 *
 * @Override
 * protected void think() {
 *     kick.setCommand("distance", 3);       // metres
 *     if (!kick.isFinished()) {
 *         kick.act(nao);                    // first stand behind the ball in the posture Stance.POSTURE
 *     }
 * }
 * }</pre>
 */
public final class PolicyPlayer {

    private static final String JOINT = "joint.";
    private static final String COMMAND = "command.";
    private static final double[] NONE = {};

    /** An input of the network: a reading at the time of the action, or of an earlier action. */
    private record Input(ToDoubleFunction<Robot> reading, int age) {}

    /** An output of the network: the speed of a joint, or an offset of its angle. */
    private record Output(Joint joint, boolean isSpeed, double rangeDegrees) {}

    private final InferenceSession session;
    private final List<Input> inputs;
    private final List<Output> outputs;
    private final int oldest;
    private final Deque<double[]> readings = new ArrayDeque<>();
    private final int cyclesPerAction;
    private final boolean observesGait;
    private final Optional<Motion> motion;
    private final Map<String, Double> commands = new TreeMap<>();
    private Optional<MotionGuide> guide = Optional.empty();
    private double[] progress = {};
    private Posture first = Posture.ZERO;
    private double[] action = {};
    private GaitObservation gait = new GaitObservation();
    private double[] gaitValues = NONE;
    private boolean acting;
    private int cycles;

    /**
     * Creates a player for a policy.
     *
     * @param policy a policy from {@code robonewbie learn} or {@code python -m robonewbie.train}
     * @throws IllegalArgumentException if an input is not a sensor of the robot or an output is not a joint
     */
    public PolicyPlayer(Policy policy) {
        session = policy.network().session();
        motion = Optional.ofNullable(policy.numbers().get(MotionGuide.MOTION))
                .map(numbers -> MotionGuide.motion(
                        policy.task(),
                        numbers.stream().mapToDouble(Double::doubleValue).toArray()));
        inputs = policy.inputs().stream()
                .map(input -> new Input(reading(input.current()), input.age()))
                .toList();
        outputs = policy.outputs().stream().map(PolicyPlayer::output).toList();
        oldest = inputs.stream().mapToInt(Input::age).max().orElse(0);
        cyclesPerAction = policy.cyclesPerAction();
        observesGait = policy.inputs().stream().map(Quantity::current).anyMatch(GaitObservation.INPUTS::contains);
    }

    private ToDoubleFunction<Robot> reading(Quantity input) {
        int part = MotionGuide.PROGRESS.indexOf(input);
        if (part >= 0 && motion.isPresent()) {
            return robot -> progress[part];
        }
        if (input.name().startsWith(COMMAND)) {
            String command = input.name().substring(COMMAND.length());
            commands.put(command, 0.0);
            return robot -> commands.getOrDefault(command, 0.0) / input.factor();
        }
        int observed = GaitObservation.INPUTS.indexOf(input);
        if (observed >= 0) {
            return robot -> gaitValues[observed];
        }
        return SensedQuantity.of(input).reading();
    }

    private static Output output(Quantity output) {
        return Arrays.stream(Joint.values())
                .filter(joint -> output.name().equals(JOINT + joint) || output.equals(Quantity.speedOf(joint)))
                .map(joint -> new Output(joint, output.equals(Quantity.speedOf(joint)), output.factor()))
                .findAny()
                .orElseThrow(() -> new IllegalArgumentException("The policy moves " + output.name()
                        + ", which is not a joint. Outputs are named like joint.LEFT_KNEE_PITCH."));
    }

    /**
     * Sets a command input of the policy.
     *
     * @param name name of the command, such as {@code distance} for a kick
     * @param value value in the unit used in training without its factor, such as degrees for {@code 30 degrees}; 0 until it is set
     * @throws IllegalArgumentException if the policy has no such command
     */
    public void setCommand(String name, double value) {
        if (!commands.containsKey(name)) {
            throw new IllegalArgumentException("This policy has no command \"" + name + "\". Its commands: "
                    + (commands.isEmpty() ? "none" : String.join(", ", commands.keySet())) + ".");
        }
        commands.put(name, value);
    }

    /** Restarts the policy in the next cycle, from the robot's posture at that time. */
    public void begin() {
        acting = false;
    }

    /** {@return whether the motion that the policy contains is over; always false without a motion} */
    public boolean isFinished() {
        return acting && guide.isPresent() && guide.get().isOver(cycles);
    }

    /**
     * Moves the joints. Call this method once per cycle.
     *
     * @param robot the robot to sense and move
     */
    public void act(Robot robot) {
        if (!acting) {
            first = posture(robot);
            guide = motion.map(one -> new MotionGuide(one, first));
            session.reset();
            readings.clear();
            gait = new GaitObservation();
            action = new double[outputs.size()];
            acting = true;
            cycles = 0;
        }
        if (observesGait) {
            gait.update(
                    posture(robot),
                    new TorsoMotion(robot.getGyro(), robot.getAcceleration()),
                    robot.getLeftFootPressure(),
                    robot.getRightFootPressure());
        }
        if (cycles % cyclesPerAction == 0) {
            gaitValues = observesGait ? gait.values(action) : NONE;
            guide.ifPresent(one -> progress = one.progress(cycles));
            action = session.apply(sense(robot));
        }
        move(robot, action);
        cycles++;
    }

    /** Reads all inputs. Before the first action, everything is as at the first action. */
    private double[] sense(Robot robot) {
        readings.addFirst(inputs.stream()
                .mapToDouble(input -> input.reading().applyAsDouble(robot))
                .toArray());
        List<double[]> rows = List.copyOf(readings);
        double[] values = new double[inputs.size()];
        Arrays.setAll(values, i -> rows.get(Math.min(inputs.get(i).age(), rows.size() - 1))[i]);
        if (rows.size() > oldest) {
            readings.removeLast();
        }
        return values;
    }

    private void move(Robot robot, double... wanted) {
        double[] degrees =
                guide.map(one -> one.posture(cycles + 1)).orElse(first).toArray();
        Set<Joint> joints = guide.isPresent() ? EnumSet.allOf(Joint.class) : EnumSet.noneOf(Joint.class);
        for (int i = 0; i < wanted.length; i++) {
            Joint joint = outputs.get(i).joint();
            if (outputs.get(i).isSpeed()) {
                robot.setJointSpeed(joint, wanted[i] * joint.maxDegreesPerSecond());
            } else {
                degrees[joint.ordinal()] += outputs.get(i).rangeDegrees() * wanted[i];
                joints.add(joint);
            }
        }
        for (Joint joint : joints) {
            robot.setJointAngle(joint, joint.clampDegrees(degrees[joint.ordinal()]));
        }
    }

    private static Posture posture(Robot robot) {
        return Posture.of(
                Arrays.stream(Joint.values()).mapToDouble(robot::getJointAngle).toArray());
    }
}
