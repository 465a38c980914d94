package org.robonewbie.workshop.jmh;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Cost of one step of the world without a server, messages or agents: the robots move randomly, spread out or in a
 * pile.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class WorldStep {

    private static final int STEPS_PER_TARGET = 25;
    private static final int STEPS_PER_THROW = 500;

    /** Number of robots. */
    @Param({"1", "6", "22"})
    public int robots = 1;

    /** Whether the robots are dropped in a pile every ten seconds. */
    @Param({"false", "true"})
    public boolean heap;

    private final Random random = new Random(1);
    private SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private int step;

    /** Creates the state of one thread. */
    public WorldStep() {}

    /**
     * Runs the benchmark with the allocation profiler.
     *
     * @param args ignored
     * @throws RunnerException if JMH cannot run
     */
    public static void main(String[] args) throws RunnerException {
        new Runner(new OptionsBuilder()
                        .include(WorldStep.class.getSimpleName())
                        .addProfiler("gc")
                        .build())
                .run();
    }

    /** Creates the world. */
    @Setup(Level.Trial)
    public void begin() {
        world = new SoccerWorld(SoccerField.LEAGUE);
        for (int i = 0; i < robots; i++) {
            world.addRobot(RobotType.TYPE_0).moveUpright(place(i), 0);
        }
    }

    /** Runs one step of 20 ms, with new commands every half second. */
    @Benchmark
    public void step() {
        if (heap && step % STEPS_PER_THROW == 0) {
            for (int i = 0; i < robots; i++) {
                world.robots().get(i).moveUpright(place(i), 70.0 * i);
            }
        }
        if (step % STEPS_PER_TARGET == 0) {
            world.robots().forEach(this::command);
        }
        world.step();
        step++;
    }

    private void command(Robot robot) {
        for (int hinge = 0; hinge < robot.nao().hinges().size(); hinge++) {
            robot.setMotorSpeed(hinge, 6 * random.nextDouble() - 3);
        }
    }

    private Vector3 place(int robot) {
        return heap
                ? new Vector3(0.3 * (robot % 3), 0.3 * (robot / 3 % 3), 0.6 + 0.5 * (robot / 9))
                : new Vector3(-13 + 2.5 * (robot % 11), robot < 11 ? 4 : -4, 0.39);
    }
}
