package org.robonewbie.learning.policy;

import java.util.Optional;
import java.util.stream.IntStream;
import org.robonewbie.agent.policy.InferenceSession;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.learning.environment.ObservedQuantity;
import org.robonewbie.learning.environment.TrainingEnvironment;
import org.robonewbie.learning.environment.VelocityError;

/**
 * Result of one episode of a policy.
 *
 * @param cycles the length of the episode
 * @param reward the undiscounted return
 * @param fallen whether the robot fell
 * @param success whether the task was achieved at the end of the episode
 * @param velocityError the error of a commanded velocity; none in most tasks
 */
record Rollout(int cycles, double reward, boolean fallen, boolean success, VelocityError velocityError) {

    /** Plays an episode. */
    static Rollout of(TrainingEnvironment environment, Policy policy, long seed) {
        int[] indices = policy.inputs().stream()
                .mapToInt(input -> index(environment, input))
                .toArray();
        environment.reset(seed, Optional.of(policy));
        InferenceSession session = policy.network().session();
        double reward = 0;
        while (!environment.isTerminated() && !environment.isTruncated()) {
            double[] observation = environment.observation();
            double[] inputs =
                    IntStream.of(indices).mapToDouble(i -> observation[i]).toArray();
            environment.step(session.apply(inputs));
            reward += environment.reward();
        }
        return new Rollout(
                environment.cycles(),
                reward,
                environment.task().hasFallen(),
                environment.task().isDone(),
                environment.task().velocityError());
    }

    private static int index(TrainingEnvironment environment, Quantity input) {
        for (int i = 0; i < environment.quantities().size(); i++) {
            ObservedQuantity observed = environment.quantities().get(i);
            if (observed.name().equals(input.name()) && observed.unit().equals(input.unit())) {
                return i;
            }
        }
        throw new IllegalArgumentException("The policy needs the input " + input.name() + " in " + input.unit()
                + ", which this task does not observe. Was it trained for another task?");
    }
}
