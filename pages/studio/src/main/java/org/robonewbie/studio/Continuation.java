package org.robonewbie.studio;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.scene.KeptMoment;
import org.robonewbie.studio.scene.LivingWorld;

/** Continues the running simulation from a kept moment; puppets take the places of robots that have left. */
final class Continuation implements LivingWorld {

    private final Stage stage;

    Continuation(Stage stage) {
        this.stage = stage;
    }

    @Override
    public SoccerField field() {
        return stage.simulation().field();
    }

    @Override
    public WorldSnapshot now() {
        return stage.now();
    }

    @Override
    public Optional<WorldState> save() {
        return stage.waitingRoom().answer(Optional.empty(), stage.simulation()::save);
    }

    @Override
    public Restored goOnFrom(KeptMoment moment) {
        if (!stage.simulation().hasClock()) {
            throw new IllegalStateException("A server of another process cannot be put into a kept state.");
        }
        if (stage.simulation().trial().isPresent()) {
            throw new IllegalStateException(
                    "This trial counts, so it goes its way. Go back to a scene when it is over.");
        }
        awaitRobots(moment.state());
        stage.simulation().order(new Order.Pause());
        return restore(moment);
    }

    private Restored restore(KeptMoment moment) {
        OptionalInt agents = moment.exact()
                .filter(state -> players(moment.state()).equals(players(stage.now())))
                .map(state -> stage.waitingRoom()
                        .answer(
                                OptionalInt.empty(),
                                (Consumer<OptionalInt> receiver) ->
                                        stage.simulation().restore(state, receiver)))
                .orElse(OptionalInt.empty());
        if (agents.isEmpty()) {
            stage.simulation().restore(moment.before(), moment.state());
        }
        return new Restored(agents.isPresent(), agents.orElse(0));
    }

    /** Keeps the present moment. */
    KeptMoment keep() {
        Optional<WorldState> exact = save();
        return new KeptMoment(now(), now(), exact);
    }

    /**
     * Goes on from a moment; the clock goes on if it was going. Puppets stand in for robots that have left only if that is wanted.
     * Returns what people should know of it; empty if the world is as it was to the bit.
     */
    String goBackTo(KeptMoment moment, boolean withAbsent) {
        boolean wasGoing = !stage.now().paused();
        if (withAbsent) {
            awaitRobots(moment.state());
        }
        stage.simulation().order(new Order.Pause());
        Restored restored = restore(moment);
        if (wasGoing) {
            stage.simulation().order(new Order.Resume());
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
        if (stage.puppets().fillUp(state, stage.now()) == 0 || !stage.puppets().isOpen()) {
            return;
        }
        stage.simulation().order(new Order.Resume());
        stage.waitingRoom().await(() -> stage.puppets().fillUp(state, stage.now()) == 0);
    }
}
