package org.robonewbie.studio;

import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.studio.program.Arena;
import org.robonewbie.studio.scene.Checkpoint;

/** The pitch that the pages show, for programs that come and go. */
final class ShownArena implements Arena {

    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    /** Until then an agent still hears its number and goes to its first place; a world that jumps would confuse it. */
    private static final int CYCLES_TO_SETTLE = 12;

    private final StudioContext context;
    private final Restore world;

    ShownArena(StudioContext context) {
        this.context = context;
        this.world = new Restore(context);
    }

    @Override
    public OptionalInt agentPort() {
        return context.simulation().agentPort();
    }

    @Override
    public Moment keep() {
        Checkpoint moment = world.keep();
        return stillWanted -> goOn(moment, stillWanted);
    }

    private void goOn(Checkpoint moment, BooleanSupplier stillWanted) {
        Set<Integer> before = players(moment.state());
        BooleanSupplier hasCome = () -> !before.containsAll(players(context.now()));
        if (await(hasCome, stillWanted)) {
            settle(moment.state().speed(), stillWanted);
            world.goBackTo(moment, false);
        }
        if (moment.state().paused()) {
            context.simulation().order(new Order.Pause());
        }
    }

    /** These cycles are taken back, so nobody need see them in real time. */
    private void settle(double speed, BooleanSupplier stillWanted) {
        long settled = context.now().cycle() + CYCLES_TO_SETTLE;
        context.simulation().order(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE));
        await(() -> context.now().cycle() >= settled, stillWanted);
        context.simulation().order(new Order.SetSpeed(speed));
    }

    private static boolean await(BooleanSupplier condition, BooleanSupplier stillWanted) {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!condition.getAsBoolean() && stillWanted.getAsBoolean() && System.nanoTime() < end) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
        return condition.getAsBoolean();
    }

    /** The connections of all robots that have joined a team. */
    private static Set<Integer> players(WorldSnapshot state) {
        return state.robots().stream()
                .filter(robot -> !robot.team().isEmpty())
                .map(RobotSnapshot::id)
                .collect(Collectors.toSet());
    }

    @Override
    public void reset() {
        context.simulation().order(new Order.Reset());
    }

    @Override
    public void resume() {
        if (context.simulation().hasClock()) {
            context.simulation().order(new Order.Resume());
        }
    }
}
