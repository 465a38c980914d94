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

/** The displayed pitch, used as the arena for programs from the editor. */
final class ShownArena implements Arena {

    private static final long TIMEOUT_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    /**
     * Number of cycles that a new agent needs to receive its player number and move to its line-up position. Restoring a
     * state earlier would confuse the agent.
     */
    private static final int CYCLES_TO_SETTLE = 12;

    private final LiveFeed context;
    private final Restore world;

    ShownArena(LiveFeed context) {
        this.context = context;
        this.world = new Restore(context);
    }

    @Override
    public OptionalInt agentPort() {
        return context.simulation().agentPort();
    }

    @Override
    public Moment keep() {
        if (!context.simulation().hasClock()) {
            return isWanted -> {}; // the server goes on meanwhile
        }
        Checkpoint moment = world.keep();
        return isWanted -> restore(moment, isWanted);
    }

    private void restore(Checkpoint moment, BooleanSupplier isWanted) {
        Set<Integer> before = players(moment.state());
        BooleanSupplier hasCome = () -> !before.containsAll(players(context.now()));
        if (await(hasCome, isWanted)) {
            settle(moment.state().speed(), isWanted);
            world.goBackTo(moment, false);
        }
        if (moment.state().paused()) {
            context.simulation().order(new Order.Pause());
        }
    }

    /** Runs the settling cycles as fast as possible; restoring the saved state discards them. */
    private void settle(double speed, BooleanSupplier isWanted) {
        long settled = context.now().cycle() + CYCLES_TO_SETTLE;
        context.simulation().order(new Order.SetSpeed(SimulationControl.AS_FAST_AS_POSSIBLE));
        await(() -> context.now().cycle() >= settled, isWanted);
        context.simulation().order(new Order.SetSpeed(speed));
    }

    private static boolean await(BooleanSupplier condition, BooleanSupplier isWanted) {
        long end = System.nanoTime() + TIMEOUT_NANOS;
        while (!condition.getAsBoolean() && isWanted.getAsBoolean() && System.nanoTime() < end) {
            LockSupport.parkNanos(POLL_NANOS);
        }
        return condition.getAsBoolean();
    }

    /** Returns the connection numbers of all robots that have joined a team. */
    private static Set<Integer> players(WorldSnapshot state) {
        return state.robots().stream()
                .filter(robot -> !robot.team().isEmpty())
                .map(RobotSnapshot::id)
                .collect(Collectors.toSet());
    }

    @Override
    public void clearTelemetry() {
        context.clearTelemetry();
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
