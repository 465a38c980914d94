package org.robonewbie.simulator;

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
}
