package org.robonewbie.web;

import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/** A world that the user may change freely: states can be restored, and manually controlled robots (puppets) can join. */
interface EditableWorld extends SteppedWorld, PuppetProvider {

    /** {@return the bit-exact state; empty while a robot's reply is pending} */
    Optional<WorldState> save();

    /**
     * Restores a saved state.
     *
     * @param state the state
     * @return number of agents that have restored their own states; empty if the state belongs to another world or a robot's reply is
     *     pending
     */
    OptionalInt restore(WorldState state);

    /**
     * Restores an observed state approximately.
     *
     * @param before an earlier state, used to estimate velocities
     * @param moment the state
     */
    void restore(WorldSnapshot before, WorldSnapshot moment);

    /** {@return a connection for another robot} */
    AgentLink connect();
}
