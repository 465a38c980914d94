package org.robonewbie.learning.policy;

import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.IntFunction;
import java.util.function.IntToLongFunction;
import java.util.stream.IntStream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.learning.environment.TrainingEnvironment;

/** Environments that play episodes in parallel; the result does not depend on their number. */
final class RolloutWorkers implements AutoCloseable {

    private final PolicyModel model;
    private final Queue<TrainingEnvironment> idle = new ConcurrentLinkedQueue<>();

    RolloutWorkers(PolicyModel model) {
        this.model = model;
    }

    /** Plays episodes, each with its policy and seed. */
    RolloutStatistics play(int count, IntFunction<Policy> policies, IntToLongFunction seeds) {
        List<Rollout> rollouts = IntStream.range(0, count)
                .parallel()
                .mapToObj(i -> play(policies.apply(i), seeds.applyAsLong(i)))
                .toList();
        return new RolloutStatistics(rollouts);
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
        idle.forEach(TrainingEnvironment::close);
    }
}
