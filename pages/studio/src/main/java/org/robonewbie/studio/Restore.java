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

/** Restores checkpoints of the running simulation. Manually controlled robots (puppets) replace robots that have left. */
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
    public Restored restore(Checkpoint moment) {
        if (!context.simulation().hasClock()) {
            throw new IllegalStateException("A simulation in another process cannot be restored.");
        }
        if (context.simulation().trial().isPresent()) {
            throw new IllegalStateException(
                    "A graded trial cannot be changed. Restore the scene after the trial has ended.");
        }
        awaitRobots(moment.state());
        context.simulation().order(new Order.Pause());
        return apply(moment);
    }

    private Restored apply(Checkpoint moment) {
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

    /** Takes a checkpoint of the current state. */
    Checkpoint keep() {
        Optional<WorldState> exact = save();
        return new Checkpoint(now(), now(), exact);
    }

    /**
     * Restores a checkpoint. A running clock keeps running.
     *
     * @param withAbsent whether puppets replace robots that have left
     * @return a remark for the user; empty if the state is restored exactly
     */
    String goBackTo(Checkpoint moment, boolean withAbsent) {
        boolean wasGoing = !context.now().paused();
        if (withAbsent) {
            awaitRobots(moment.state());
        }
        context.simulation().order(new Order.Pause());
        Restored restored = apply(moment);
        if (wasGoing) {
            context.simulation().order(new Order.Resume());
        }
        return restored.exact() ? "" : "The world was restored only approximately: speeds are estimated.";
    }

    /** Returns the identities and body types of all robots; an exact state can be restored only if they match. */
    private static List<String> players(WorldSnapshot state) {
        return state.robots().stream()
                .map(robot -> robot.team() + " " + robot.number() + " " + robot.side() + " " + robot.type())
                .sorted()
                .toList();
    }

    /**
     * Adds puppets for missing robots and waits until they have joined, which requires a running clock. Stops waiting
     * after a timeout.
     */
    private void awaitRobots(WorldSnapshot state) {
        if (context.puppets().fillUp(state, context.now()) == 0
                || !context.puppets().isOpen()) {
            return;
        }
        context.simulation().order(new Order.Resume());
        context.commandQueue().await(() -> context.puppets().fillUp(state, context.now()) == 0);
    }
}
