package org.robonewbie.simulator.benchmark;

import java.util.List;
import java.util.OptionalDouble;

/**
 * How fast one scene was.
 *
 * @param robots how many robots took part
 * @param scene what they did
 * @param threads how many threads simulated them and thought for them; 0 for a server of another process
 * @param cycles how many cycles of 20 ms were measured
 * @param realTimeFactor simulated seconds per second, agents included
 * @param cpuMillisPerCycle processor time of the server alone per cycle in milliseconds; empty if unknown
 * @param allocatedBytesPerCycle memory that the server asks for per cycle; empty if unknown
 * @param peakMemoryBytes the most memory that was in use at a time in this process
 * @param heap the memory in use after collections of garbage, from time to time; empty unless the plan asks for it
 */
public record BenchmarkRun(
        int robots,
        Scene scene,
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
