package org.robonewbie.studio.scene;

import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/** The running simulation, as scenes need it. */
public interface RestorableSimulation {

    /** {@return the pitch} */
    SoccerField field();

    /**
     * {@return the present state}
     * @throws IllegalStateException if there was none yet
     */
    WorldSnapshot now();

    /** {@return the present state to the bit; empty where it cannot be saved, as in a server of another process} */
    Optional<WorldState> save();

    /**
     * Goes on from a state, with the clock stopped: to the bit if it was saved so and the same robots play now, else nearly.
     * Puppets stand in for robots that do not play now.
     *
     * @param moment the state
     * @return how much of it is as it was
     * @throws IllegalStateException if that is not possible; the message says why
     */
    Restored goOnFrom(Checkpoint moment);

    /**
     * How much of a kept moment is back.
     *
     * @param exact whether the world is as it was to the bit; else speeds are estimated
     * @param agents how many agents have taken on their own states, which they offered when the moment was saved
     */
    record Restored(boolean exact, int agents) {}
}
