package org.robonewbie.workshop.speed;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Settings of a benchmark.
 *
 * @param robots numbers of robots, each 1 to 22
 * @param scenes scenes to play with each number of robots
 * @param warmUpSeconds simulated seconds before the measurement, for the JIT compiler
 * @param seconds simulated seconds to measure
 * @param heapEverySeconds simulated seconds between memory samples; empty for no samples
 * @param threads number of threads for the embedded server and, between its cycles, for the agents
 * @param other server to measure; empty for the embedded one
 */
public record BenchmarkPlan(
        List<Integer> robots,
        List<CrowdScene> scenes,
        double warmUpSeconds,
        double seconds,
        OptionalDouble heapEverySeconds,
        int threads,
        Optional<ServerAddress> other) {

    /** Stores unmodifiable copies of the lists. */
    public BenchmarkPlan {
        robots = List.copyOf(robots);
        scenes = List.copyOf(scenes);
    }
}
