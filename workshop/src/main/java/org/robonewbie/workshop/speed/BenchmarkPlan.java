package org.robonewbie.workshop.speed;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What is measured.
 *
 * @param robots numbers of robots, each 1 to 22
 * @param scenes what they do
 * @param warmUpSeconds simulated seconds before the measurement, in which Java compiles what is used most
 * @param seconds simulated seconds that are measured
 * @param heapEverySeconds simulated seconds between memory samples; empty to take none
 * @param threads how many threads our own server works on, and robots think on between two of its cycles
 * @param other the server to be measured; ours in this process if empty
 */
public record BenchmarkPlan(
        List<Integer> robots,
        List<CrowdScene> scenes,
        double warmUpSeconds,
        double seconds,
        OptionalDouble heapEverySeconds,
        int threads,
        Optional<ServerAddress> other) {

    /** Makes the lists unmodifiable. */
    public BenchmarkPlan {
        robots = List.copyOf(robots);
        scenes = List.copyOf(scenes);
    }
}
