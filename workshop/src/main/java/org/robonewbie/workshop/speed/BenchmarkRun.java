package org.robonewbie.workshop.speed;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Speed of one scene.
 *
 * @param robots number of robots
 * @param scene what the robots did
 * @param threads number of threads of the embedded server and the agents; 0 for a server in another process
 * @param realTimeFactor simulated seconds per real second, including the agents
 * @param cpuMillisPerCycle processor time of the server alone per cycle in milliseconds; empty if unknown
 * @param allocatedBytesPerCycle memory that the server allocates per cycle; empty if unknown
 * @param cycles number of measured cycles of 20 ms
 * @param peakMemoryBytes peak heap usage of this process
 * @param heap memory in use after garbage collections, sampled at intervals; empty unless the plan requests it
 */
public record BenchmarkRun(
        int robots,
        CrowdScene scene,
        int threads,
        double realTimeFactor,
        OptionalDouble cpuMillisPerCycle,
        OptionalDouble allocatedBytesPerCycle,
        int cycles,
        long peakMemoryBytes,
        List<HeapSample> heap) {

    /** Stores an unmodifiable copy of the list. */
    public BenchmarkRun {
        heap = List.copyOf(heap);
    }
}
