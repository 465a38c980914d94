package org.robonewbie.studio;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.scene.Checkpoint;
import org.robonewbie.studio.scene.RestorableSimulation;

/** Continues the running simulation from a kept moment; puppets take the places of robots that have left. */
final class Restore implements RestorableSimulation {

    private final StudioContext context;

    Restore(StudioContext context) {
        this.context = context;
    }

    @Override
    public SoccerField field() {
        return context.simulation().field();
    }

    @Override
    public WorldSnapshot now() {
        return context.now();
    }

    @Override
    public Optional<WorldState> save() {
        return context.commandQueue().answer(Optional.empty(), context.simulation()::save);
    }

    @Override
    public Restored goOnFrom(Checkpoint moment) {
        if (!context.simulation().hasClock()) {
            throw new IllegalStateException("A server of another process cannot be put into a kept state.");
        }
        if (context.simulation().trial().isPresent()) {
            throw new IllegalStateException(
                    "This trial counts, so it goes its way. Go back to a scene when it is over.");
        }
        awaitRobots(moment.state());
        context.simulation().order(new Order.Pause());
        return restore(moment);
    }

    private Restored restore(Checkpoint moment) {
        OptionalInt agents = moment.exact()
                .filter(state -> players(moment.state()).equals(players(context.now())))
                .map(state -> context.commandQueue()
                        .answer(
                                OptionalInt.empty(),
                                (Consumer<OptionalInt> receiver) ->
                                        context.simulation().restore(state, receiver)))
                .orElse(OptionalInt.empty());
        if (agents.isEmpty()) {
            context.simulation().restore(moment.before(), moment.state());
        }
        return new Restored(agents.isPresent(), agents.orElse(0));
    }

    /** Keeps the present moment. */
    Checkpoint keep() {
        Optional<WorldState> exact = save();
        return new Checkpoint(now(), now(), exact);
    }

    /**
     * Goes on from a moment; the clock goes on if it was going. Puppets stand in for robots that have left only if that is wanted.
     * Returns what people should know of it; empty if the world is as it was to the bit.
     */
    String goBackTo(Checkpoint moment, boolean withAbsent) {
        boolean wasGoing = !context.now().paused();
        if (withAbsent) {
            awaitRobots(moment.state());
        }
        context.simulation().order(new Order.Pause());
        Restored restored = restore(moment);
        if (wasGoing) {
            context.simulation().order(new Order.Resume());
        }
        return restored.exact() ? "" : "The world is nearly as it was: speeds are estimated.";
    }

    /** Lists who plays and in which body; a saved state gives each of them its own body again. */
    private static List<String> players(WorldSnapshot state) {
        return state.robots().stream()
                .map(robot -> robot.team() + " " + robot.number() + " " + robot.side() + " " + robot.type())
                .sorted()
                .toList();
    }

    /** Newcomers need a running clock; whoever does not come is left out. */
    private void awaitRobots(WorldSnapshot state) {
        if (context.puppets().fillUp(state, context.now()) == 0
                || !context.puppets().isOpen()) {
            return;
        }
        context.simulation().order(new Order.Resume());
        context.commandQueue().await(() -> context.puppets().fillUp(state, context.now()) == 0);
    }
}
