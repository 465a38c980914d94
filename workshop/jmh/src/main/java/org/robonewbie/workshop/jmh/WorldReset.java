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

/** Cost of resetting a world to standing robots: by restoring a saved state, and by letting the robots settle. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class WorldReset {

    private static final int STEPS_TO_SETTLE = 50;

    /** Number of robots. */
    @Param({"1", "6", "22"})
    public int robots = 1;

    private final SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
    private WorldState settled = world.save();

    /** Creates the world that one benchmark thread resets. */
    public WorldReset() {}

    /** Creates the world. */
    @Setup
    public void begin() {
        for (int i = 0; i < robots; i++) {
            world.addRobot(RobotType.TYPE_0);
        }
        settle();
        settled = world.save();
    }

    /** Places the robots and simulates until they come to rest. */
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
     * Saves the state of the world.
     *
     * @return the state
     */
    @Benchmark
    public WorldState save() {
        return world.save();
    }

    /** Restores the saved state after one step. */
    @Benchmark
    public void stepAndRestore() {
        world.step();
        world.restore(settled);
    }

    /** Restores the saved state. */
    @Benchmark
    public void restore() {
        world.restore(settled);
    }
}
