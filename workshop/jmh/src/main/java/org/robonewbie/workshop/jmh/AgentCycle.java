package org.robonewbie.workshop.jmh;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/**
 * Cost of the framework per cycle of 20 ms for a robot program: receiving and parsing a recorded server message (two teams; every third
 * message has camera data), sensing, acting and formatting the reply. Nothing is sent, and the program performs no computation.
 *
 * <p>{@link #perception} measures the immutable perception alone; any additional allocations in the other benchmarks
 * are overhead. Sample mode yields median times but itself allocates memory, so take the allocations from the
 * average-time results.
 */
@State(Scope.Thread)
@BenchmarkMode({Mode.SampleTime, Mode.AverageTime})
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 10, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class AgentCycle {

    private final ReplayLink link = new ReplayLink();
    private final MessageBuffer buffer = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private final Nao nao = Nao.connect(Options.none().with("seed", "1").with("headless", "true"));

    /** Creates the state of one thread. */
    public AgentCycle() {}

    /**
     * Runs the benchmark with the allocation profiler.
     *
     * @param args ignored
     * @throws RunnerException if JMH cannot run
     */
    public static void main(String[] args) throws RunnerException {
        new Runner(new OptionsBuilder()
                        .include(AgentCycle.class.getSimpleName())
                        .addProfiler("gc")
                        .build())
                .run();
    }

    /** Stops all joints. */
    @Setup
    public void begin() {
        nao.sense();
        nao.act();
    }

    /**
     * Receives and parses a message.
     *
     * @return the perception
     */
    @Benchmark
    public PerceptorMessage perception() {
        link.receive(buffer);
        return reader.read(buffer);
    }

    /** Runs one cycle with a command to one joint. */
    @Benchmark
    public void cycle() {
        nao.sense();
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH) < 30 ? 60 : 0);
        nao.act();
    }

    /** Runs one cycle with a motion of all joints. */
    @Benchmark
    public void cycleWithMotion() {
        nao.sense();
        if (nao.motions().isFinished()) {
            nao.motions().loop("walk-forward");
        }
        nao.act();
    }

    /** Runs one cycle with the walk engine. */
    @Benchmark
    public void cycleWithWalk() {
        nao.sense();
        nao.walk().towards(0.3, 0, 0);
        nao.act();
    }
}
