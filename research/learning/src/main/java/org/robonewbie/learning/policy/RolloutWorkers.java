package org.robonewbie.learning.policy;

import java.io.IOException;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.IntFunction;
import java.util.function.IntToLongFunction;
import java.util.stream.IntStream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.learning.environment.TrainingEnvironment;
import org.robonewbie.trial.batch.BatchRunner;
import org.robonewbie.trial.batch.ThreadRunner;

/** Pool of environments that play episodes in parallel. Results do not depend on the number of environments. */
final class RolloutWorkers implements AutoCloseable {

    private final PolicyModel model;
    private final BatchRunner runner = new ThreadRunner();
    private final Queue<TrainingEnvironment> idle = new ConcurrentLinkedQueue<>();

    RolloutWorkers(PolicyModel model) {
        this.model = model;
    }

    /** Plays {@code count} episodes. The functions return the policy and the seed of an episode, given its index. */
    RolloutStatistics play(int count, IntFunction<Policy> policies, IntToLongFunction seeds) throws IOException {
        return new RolloutStatistics(runner.run(
                IntStream.range(0, count).boxed().toList(), i -> play(policies.apply(i), seeds.applyAsLong(i))));
    }

    private Rollout play(Policy policy, long seed) {
        TrainingEnvironment environment = Optional.ofNullable(idle.poll()).orElseGet(model::open);
        try {
            model.prepare(environment, policy);
            return Rollout.of(environment, policy, seed);
        } finally {
            idle.add(environment);
        }
    }

    @Override
    public void close() {
        runner.close();
        idle.forEach(TrainingEnvironment::close);
    }
}
