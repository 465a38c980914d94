package org.robonewbie.agent.walk;

import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;

/**
 * A walk that was learned: the {@link WalkEngine} with other numbers, and a reflex that corrects what it does. It needs joint
 * angles, gyroscope, accelerometer and the soles' pressure, so it walks on any SimSpark server.
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
 * @param style the numbers of the engine
 * @param reflex what corrects it
 */
public record PolicyWalk(WalkStyle style, WalkReflex reflex) {

    /** Name of a policy's numbers for {@link FastWalk#style}. */
    public static final String GAIT = "gait";

    private static final String STEP = "step-millis";
    private static final String MAX = "most-forward-left-turn-backward";

    /**
     * Takes a policy.
     *
     * @param policy a policy for walking, such as {@code PolicyFile.shipped("walk")}
     * @throws IllegalArgumentException if it was learned for something else
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
        return FastWalk.style((int) policy.numbers(STEP, 1)[0], policy.numbers(GAIT, FastWalk.PARAMETERS))
                .withMost(new WalkVelocity(most[0], most[1], most[2]), most[3]);
    }

    /**
     * Makes a policy of what was learned.
     *
     * @param task what was learned
     * @param about how it was learned
     * @param stepMillis time of one step, a multiple of 20
     * @param most the largest speeds
     * @param backward the largest speed backward, metres per second
     * @param gait the coordinates of {@link FastWalk#style}
     * @param network takes {@link ResidualPolicy#INPUTS} and gives {@link ResidualPolicy#OUTPUTS}
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
