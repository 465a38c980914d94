package org.robonewbie.agent.policy;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.agent.Robot;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Posture;

/**
 * Does what a learning program has learned in a task of the Python package, from the robot's messages alone: joints go to the first
 * posture, moved by what the network says.
 *
 * <pre>{@code
 * private final PolicyPlayer balance = new PolicyPlayer(PolicyFile.read(Path.of("Stand.policy")));
 *
 * @Override
 * protected void think() {
 *     if (motions.isFinished()) {      // the robot is in the stance
 *         balance.act(nao);
 *     }
 * }
 * }</pre>
 */
public final class PolicyPlayer {

    private static final String JOINT = "joint.";
    private static final String RANGE = "range-degrees";

    private final Network network;
    private final List<FeltQuantity> inputs;
    private final List<Joint> joints;
    private final double rangeDegrees;
    private Posture first = Posture.ZERO;
    private boolean acting;

    /**
     * Takes a policy.
     *
     * @param policy what was learned by {@code python -m robonewbie.train}
     * @throws IllegalArgumentException if it takes what a robot does not feel, or moves what is no joint
     */
    public PolicyPlayer(Policy policy) {
        network = policy.network();
        inputs = policy.inputs().stream().map(FeltQuantity::of).toList();
        joints = policy.outputs().stream().map(PolicyPlayer::joint).toList();
        rangeDegrees = policy.numbers(RANGE, 1)[0];
    }

    private static Joint joint(Quantity output) {
        return Arrays.stream(Joint.values())
                .filter(joint -> output.name().equals(JOINT + joint))
                .findAny()
                .orElseThrow(() -> new IllegalArgumentException("The policy moves " + output.name()
                        + ", which is no joint. Outputs are called joint.LEFT_KNEE_PITCH and the like."));
    }

    /** Begins again with the posture that the robot has in the next cycle. */
    public void begin() {
        acting = false;
    }

    /**
     * Moves the joints, to be called once in each cycle.
     *
     * @param robot feels and moves
     */
    public void act(Robot robot) {
        if (!acting) {
            first = posture(robot);
            acting = true;
        }
        double[] felt = inputs.stream()
                .mapToDouble(input -> input.reading().applyAsDouble(robot))
                .toArray();
        double[] wanted = network.apply(felt);
        for (int i = 0; i < wanted.length; i++) {
            Joint joint = joints.get(i);
            robot.setJointAngle(joint, joint.clampDegrees(first.degrees(joint) + rangeDegrees * wanted[i]));
        }
    }

    private static Posture posture(Robot robot) {
        return Posture.of(
                Arrays.stream(Joint.values()).mapToDouble(robot::getJointAngle).toArray());
    }
}
