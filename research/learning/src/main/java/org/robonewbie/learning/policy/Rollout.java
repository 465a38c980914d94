package org.robonewbie.learning.policy;

import java.util.Optional;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.learning.environment.ObservedQuantity;
import org.robonewbie.learning.environment.TrainingEnvironment;
import org.robonewbie.learning.environment.VelocityError;

/**
 * Result of one episode of a policy.
 *
 * @param cycles length of the episode
 * @param reward sum of all rewards
 * @param fallen whether the robot fell
 * @param success whether the task was done at the end
 * @param velocityError errors of a commanded velocity; none in most tasks
 */
record Rollout(int cycles, double reward, boolean fallen, boolean success, VelocityError velocityError) {

    /** Plays an episode. */
    static Rollout of(TrainingEnvironment environment, Policy policy, long seed) {
        int[] places = policy.inputs().stream()
                .mapToInt(input -> place(environment, input))
                .toArray();
        environment.reset(seed, Optional.of(policy));
        double reward = 0;
        while (!environment.isTerminated() && !environment.isTruncated()) {
            environment.step(policy.network().apply(taken(places, environment.observation())));
            reward += environment.reward();
        }
        return new Rollout(
                environment.cycles(),
                reward,
                environment.task().hasFallen(),
                environment.task().isDone(),
                environment.task().velocityError());
    }

    private static double[] taken(int[] places, double... observation) {
        double[] taken = new double[places.length];
        for (int i = 0; i < places.length; i++) {
            taken[i] = observation[places[i]];
        }
        return taken;
    }

    private static int place(TrainingEnvironment environment, Quantity input) {
        for (int i = 0; i < environment.quantities().size(); i++) {
            ObservedQuantity observed = environment.quantities().get(i);
            if (observed.name().equals(input.name()) && observed.unit().equals(input.unit())) {
                return i;
            }
        }
        throw new IllegalArgumentException("The policy takes " + input.name() + " in " + input.unit()
                + ", which is not observed in this task. Was it learned for another one?");
    }
}
