package org.robonewbie.workshop.speed;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.robonewbie.nao.Cycle;

/**
 * Measures the speed of a server with agents that reply to every message.
 *
 * <p>The embedded server and its agents take turns on the same threads, so no waiting time is measured. The server's
 * processor time excludes that of the agents.
 *
 * <pre>{@code
 * BenchmarkReport report = new Benchmark(plan).run(run -> print(BenchmarkReport.line(run)), sample -> print(sample.toLine()));
 * }</pre>
 */
public final class Benchmark {

    private static final Duration PATIENCE = Duration.ofSeconds(20);

    private static final int ROBOTS_TO_WARM_UP = 2;

    private final BenchmarkPlan plan;
    private final Duration patience;

    /**
     * Creates a benchmark.
     *
     * @param plan what to measure
     */
    public Benchmark(BenchmarkPlan plan) {
        this(plan, PATIENCE);
    }

    Benchmark(BenchmarkPlan plan, Duration patience) {
        this.plan = plan;
        this.patience = patience;
    }

    /**
     * Measures every number of robots in every scene.
     *
     * @param progress receives each result as soon as it is available
     * @param heap receives each memory sample as soon as it is taken
     * @return all results
     * @throws IOException if a server cannot be reached, does not admit a robot, closes a connection or stalls; the message
     *     suggests a fix
     */
    public BenchmarkReport run(Consumer<BenchmarkRun> progress, Consumer<HeapSample> heap) throws IOException {
        if (plan.other().isEmpty()) {
            warmUp();
        }
        List<BenchmarkRun> runs = new ArrayList<>();
        for (CrowdScene scene : plan.scenes()) {
            for (int robots : plan.robots()) {
                BenchmarkRun run = measure(robots, scene, plan.seconds(), heap);
                runs.add(run);
                progress.accept(run);
            }
        }
        return new BenchmarkReport(runs);
    }

    /** Warms up the JIT compiler, so that the first run is not slower than the others. */
    private void warmUp() throws IOException {
        for (CrowdScene scene : plan.scenes()) {
            measure(ROBOTS_TO_WARM_UP, scene, Math.min(plan.seconds(), plan.warmUpSeconds()), sample -> {});
        }
    }

    private BenchmarkRun measure(int robots, CrowdScene scene, double seconds, Consumer<HeapSample> heap)
            throws IOException {
        try (BenchmarkServer server = openServer();
                AgentThreads threads = new AgentThreads(plan.threads())) {
            List<BenchmarkAgent> agents = server.gather(robots);
            server.playOn();
            int warmUp = cycles(plan.warmUpSeconds());
            int measured = cycles(seconds);
            Session session = new Session(server, threads, agents, scene);
            session.play(0, warmUp);
            resetPeakMemory();
            OptionalLong cpuBefore = server.cpuNanoseconds();
            OptionalLong bytesBefore = server.allocatedBytes();
            long start = System.nanoTime();
            List<HeapSample> samples = measured(session, warmUp, measured, heap);
            double realSeconds = (System.nanoTime() - start) * 1e-9;
            OptionalDouble cpu = perCycle(cpuBefore, server.cpuNanoseconds(), 1e6 * measured);
            OptionalDouble bytes = perCycle(bytesBefore, server.allocatedBytes(), measured);
            agents.forEach(BenchmarkAgent::leave);
            return new BenchmarkRun(
                    robots,
                    scene,
                    plan.other().isPresent() ? 0 : plan.threads(),
                    measured * Cycle.SECONDS / realSeconds,
                    cpu,
                    bytes,
                    measured,
                    peakMemory(),
                    samples);
        }
    }

    private BenchmarkServer openServer() throws IOException {
        return plan.other().isPresent()
                ? new OtherServer(plan.other().get(), patience)
                : new EmbeddedServer(plan.threads());
    }

    private static int cycles(double seconds) {
        return (int) Math.max(1, Math.round(seconds / Cycle.SECONDS));
    }

    /** Plays all cycles and, if requested, samples the memory between them. */
    private List<HeapSample> measured(Session session, int from, int measured, Consumer<HeapSample> heap)
            throws IOException {
        int part = plan.heapEverySeconds().isPresent()
                ? cycles(plan.heapEverySeconds().getAsDouble())
                : measured;
        List<HeapSample> samples = new ArrayList<>();
        for (int done = 0; done < measured; done += part) {
            int next = Math.min(measured, done + part);
            session.play(from + done, from + next);
            if (plan.heapEverySeconds().isPresent()) {
                HeapSample sample = HeapSample.at(next * Cycle.SECONDS);
                samples.add(sample);
                heap.accept(sample);
            }
        }
        return samples;
    }

    private static OptionalDouble perCycle(OptionalLong before, OptionalLong after, double divisor) {
        return before.isPresent() && after.isPresent()
                ? OptionalDouble.of((after.getAsLong() - before.getAsLong()) / divisor)
                : OptionalDouble.empty();
    }

    private static void resetPeakMemory() {
        ManagementFactory.getMemoryPoolMXBeans().forEach(MemoryPoolMXBean::resetPeakUsage);
    }

    private static long peakMemory() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP)
                .mapToLong(pool -> pool.getPeakUsage().getUsed())
                .sum();
    }

    private record Session(
            BenchmarkServer server, AgentThreads threads, List<BenchmarkAgent> agents, CrowdScene scene) {

        void play(int from, int to) throws IOException {
            for (int cycle = from; cycle < to; cycle++) {
                if (scene.placesAgain(cycle)) {
                    for (int robot = 0; robot < agents.size(); robot++) {
                        server.place(robot, scene.place(robot));
                    }
                }
                threads.act(agents, scene, cycle);
                server.cycle();
            }
        }
    }
}
