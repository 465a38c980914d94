package org.robonewbie.web;

import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/** A world in which people may do everything: go back to a moment, and let robots enter that they steer. */
interface EditableWorld extends SteppedWorld, PuppetProvider {

    /** {@return its state to the bit; empty while a robot has not answered} */
    Optional<WorldState> save();

    /**
     * Goes on from a saved state.
     *
     * @param state the state
     * @return how many agents have taken on their own states; empty if it does not fit this world, or while a robot has not answered
     */
    OptionalInt goOnFrom(WorldState state);

    /**
     * Goes on nearly from a state that was seen before.
     *
     * @param before an earlier state, from which the velocities are taken
     * @param state the state
     */
    void goOnFrom(WorldSnapshot before, WorldSnapshot moment);

    /** {@return the connection of one more robot} */
    AgentLink connect();
}
