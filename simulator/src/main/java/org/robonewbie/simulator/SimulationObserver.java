package org.robonewbie.simulator;

import org.robonewbie.simulator.soccer.MatchEvent;

/** Watches a simulation. */
@FunctionalInterface
public interface SimulationObserver {

    /**
     * Receives the state of the world after a cycle, on the simulation's thread: take it and return at once. While
     * paused it is called again about ten times per second with the same cycle.
     *
     * @param snapshot the state, immutable
     */
    void cycleEnded(WorldSnapshot snapshot);

    /**
     * Receives what happened in the game within a cycle, before that cycle is reported.
     *
     * @param event a goal, a foul or another play mode
     */
    default void happened(MatchEvent event) {}
}
