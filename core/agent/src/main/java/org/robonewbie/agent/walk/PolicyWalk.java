package org.robonewbie.agent.walk;

import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;

/**
 * A learned walk: a {@link WalkStyle} for the {@link WalkEngine}, and a reflex that corrects its postures. It uses only
 * the joint angles, gyroscope, accelerometer and foot pressure, so it works on any SimSpark server.
 *
 * <pre>{@code
 * public class Fast extends Agent {
 *     private final PolicyWalk learned = new PolicyWalk(PolicyFile.shipped("walk"));
 *
 *     @Override
 *     protected void think() {
 *         walk.setPolicy(learned);
 *         walk.towards(0.8, 0, 0);
 *     }
 * }
 * }</pre>
 *
 * @param style parameters of the engine
 * @param reflex corrects the engine's postures
 */
public record PolicyWalk(WalkStyle style, WalkReflex reflex) {

    /** Name of the policy's parameter list with the coordinates for {@link FastWalk#style}. */
    public static final String GAIT = "gait";

    private static final String STEP = "step-millis";
    private static final String MAX = "most-forward-left-turn-backward";

    /**
     * Creates a walk from a policy.
     *
     * @param policy a walking policy, such as {@code PolicyFile.shipped("walk")}
     * @throws IllegalArgumentException if it is not a walking policy
     */
    public PolicyWalk(Policy policy) {
        this(style(policy), reflex(policy));
    }

    private static WalkReflex reflex(Policy policy) {
        policy.require(ResidualPolicy.INPUTS, ResidualPolicy.OUTPUTS);
        return new ResidualPolicy(policy.network());
    }

    private static WalkStyle style(Policy policy) {
        double[] most = policy.numbers(MAX, 4);
        WalkStyle style = FastWalk.style((int) policy.numbers(STEP, 1)[0], policy.numbers(GAIT, FastWalk.PARAMETERS));
        return style.withLimits(new WalkVelocity(most[0], most[1], most[2]), most[3], style.change());
    }

    /**
     * Creates a policy from the results of training.
     *
     * @param task name of the task
     * @param about remarks on the training
     * @param stepMillis duration of a step in milliseconds, a multiple of 20
     * @param most maximum speeds
     * @param backward maximum backward speed in metres per second
     * @param gait coordinates of {@link FastWalk#style}
     * @param network maps {@link ResidualPolicy#INPUTS} to {@link ResidualPolicy#OUTPUTS}
     * @return the policy
     */
    public static Policy policy(
            String task,
            List<String> about,
            int stepMillis,
            WalkVelocity most,
            double backward,
            double[] gait,
            Network network) {
        Map<String, List<Double>> numbers = Map.of(
                GAIT, DoubleStream.of(gait).boxed().toList(),
                STEP, List.of((double) stepMillis),
                MAX, List.of(most.forward(), most.left(), most.turn(), backward));
        return new Policy(task, about, numbers, ResidualPolicy.INPUTS, ResidualPolicy.OUTPUTS, network);
    }
}
