package org.robonewbie.studio.scene;

import java.util.Optional;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/** A running simulation whose state can be saved and restored. */
public interface RestorableSimulation {

    /** {@return the pitch} */
    SoccerField field();

    /**
     * {@return the current state}
     * @throws IllegalStateException if the simulation has not started
     */
    WorldSnapshot now();

    /** {@return the bit-exact state; empty if the simulation cannot save it, for example because it runs in another process} */
    Optional<WorldState> save();

    /**
     * Restores a checkpoint and pauses the clock. The restoration is exact if the checkpoint has an exact state and the
     * same robots are playing; otherwise it is approximate. Manually controlled robots (puppets) replace robots that have
     * left.
     *
     * @param moment the checkpoint
     * @return how exact the restoration is
     * @throws IllegalStateException if the checkpoint cannot be restored; the message gives the reason
     */
    Restored restore(Checkpoint moment);

    /**
     * Result of a restoration.
     *
     * @param exact whether the world is restored bit for bit; if not, velocities are estimated
     * @param agents number of agents that have restored their own states
     */
    record Restored(boolean exact, int agents) {}
}
