package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Component of the referee with state to save; stateless by default. */
interface Memory {

    default void save(StateWriter out, Roster roster) {}

    default void restore(StateReader in, Roster roster) {}
}
