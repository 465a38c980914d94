package org.robonewbie.workshop.jmh;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.SoccerWorld;

/** What it costs to bring a world back to robots that stand still: from a saved state, and by letting them settle again. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class WorldReset {

    private static final int STEPS_TO_SETTLE = 50;

    /** How many robots there are. */
    @Param({"1", "6", "22"})
    public int robots = 1;

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private WorldState settled = world.save();

    /** Creates the state of one thread. */
    public WorldReset() {}

    /** Puts the robots on the pitch. */
    @Setup
    public void begin() {
        for (int i = 0; i < robots; i++) {
            world.addRobot(RobotType.TYPE_0);
        }
        settle();
        settled = world.save();
    }

    /** Places the robots and waits until they stand still. */
    @Benchmark
    public void settle() {
        for (int i = 0; i < robots; i++) {
            world.robots().get(i).moveUpright(new Vector3(-13 + 2.5 * (i % 11), i < 11 ? 4 : -4, 0.39), 0);
        }
        for (int step = 0; step < STEPS_TO_SETTLE; step++) {
            world.step();
        }
    }

    /**
     * Saves the world.
     *
     * @return its state
     */
    @Benchmark
    public WorldState save() {
        return world.save();
    }

    /** Goes back to the state in which the robots stand, after one step. */
    @Benchmark
    public void stepAndRestore() {
        world.step();
        world.restore(settled);
    }

    /** Goes back to the state in which the robots stand. */
    @Benchmark
    public void restore() {
        world.restore(settled);
    }
}
