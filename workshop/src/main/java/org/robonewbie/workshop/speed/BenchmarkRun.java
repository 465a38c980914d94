package org.robonewbie.workshop.speed;

import java.util.List;
import java.util.OptionalDouble;

/**
 * The speed of one scene.
 *
 * @param robots the number of robots
 * @param scene what they did
 * @param threads the number of threads that simulated them and thought for them; 0 for a server of another process
 * @param cycles the number of cycles of 20 ms that were measured
 * @param realTimeFactor simulated seconds per second, agents included
 * @param cpuMillisPerCycle processor time of the server alone per cycle in milliseconds; empty if unknown
 * @param allocatedBytesPerCycle memory that the server allocates per cycle; empty if unknown
 * @param peakMemoryBytes peak memory use of this process
 * @param heap the memory in use after garbage collections, sampled at intervals; empty unless the plan asks for it
 */
public record BenchmarkRun(
        int robots,
        CrowdScene scene,
        int threads,
        int cycles,
        double realTimeFactor,
        OptionalDouble cpuMillisPerCycle,
        OptionalDouble allocatedBytesPerCycle,
        long peakMemoryBytes,
        List<HeapSample> heap) {

    /** Makes the list unmodifiable. */
    public BenchmarkRun {
        heap = List.copyOf(heap);
    }
}
