package org.robonewbie.simulator;

import org.robonewbie.simulator.soccer.MatchEvent;

/** A listener for the cycles and events of a simulation. */
@FunctionalInterface
public interface SimulationObserver {

    /**
     * Called with the state of the world after a cycle, on the simulation thread; must return quickly. While the simulation is
     * paused, it is called about ten times per second with the same cycle.
     *
     * @param snapshot the state, immutable
     */
    void cycleEnded(WorldSnapshot snapshot);

    /**
     * Returns whether the observer needs a snapshot of this cycle. Called on the simulation thread before the snapshot is taken.
     *
     * @return whether to call {@link #cycleEnded}; the default is true
     */
    default boolean wantsSnapshot() {
        return true;
    }

    /**
     * Called for each match event in a cycle, before {@link #cycleEnded}.
     *
     * @param event a goal, a foul or a change of play mode
     */
    default void happened(MatchEvent event) {}

    /**
     * Called for each console message, such as the reason for refusing an agent. May be called on any thread.
     *
     * @param message a complete sentence
     */
    default void messagePrinted(String message) {}

    /** Called when the observed simulation is replaced by another one. May be called on any thread. */
    default void simulationReplaced() {}

    /**
     * Returns whether the observer needs the messages of a robot's agent. Called in each cycle on the simulation thread.
     *
     * @param robot id of the robot's connection, as in {@link RobotSnapshot#id}
     * @return whether to call {@link #messagesExchanged} for it; the default is false
     */
    default boolean wantsMessagesOf(int robot) {
        return false;
    }

    /**
     * Called with the messages of a cycle before {@link #cycleEnded}, on the simulation thread; must return quickly. While the
     * simulation is paused, it is called again with the same messages.
     *
     * @param messages the messages of one agent
     */
    default void messagesExchanged(AgentMessages messages) {}
}
