package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** A part of the referee that may remember something from one cycle to the next; unless it overrides these, it does not. */
interface Memory {

    /** Writes what is remembered. */
    default void save(StateWriter out, Roster roster) {}

    /** Takes on what was remembered when the state was saved. */
    default void restore(StateReader in, Roster roster) {}
}
