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
     * Returns whether the state of the world is wanted; called after each cycle on the simulation's thread, before a snapshot of
     * the world is made.
     *
     * @return whether to call {@link #cycleEnded}; yes unless overridden
     */
    default boolean wantsSnapshot() {
        return true;
    }

    /**
     * Receives what happened in the game within a cycle, before that cycle is reported.
     *
     * @param event a goal, a foul or another play mode
     */
    default void happened(MatchEvent event) {}

    /**
     * Receives what the simulator tells people, such as why it refuses an agent; called from any thread.
     *
     * @param sentence a complete sentence
     */
    default void told(String sentence) {}

    /** Is told that from now on another simulation is watched than before; called from any thread. */
    default void anotherBegins() {}

    /**
     * Returns whether the messages of a robot's agent are wanted; called in each cycle on the simulation's thread.
     *
     * @param robot number of the robot's connection, as in {@link RobotSnapshot#id}
     * @return whether to call {@link #messagesExchanged} for it; false unless overridden
     */
    default boolean wantsMessagesOf(int robot) {
        return false;
    }

    /**
     * Receives the messages of a cycle before {@link #cycleEnded} tells its state, on the simulation's thread: take them and
     * return at once. While paused they come again.
     *
     * @param messages what was said
     */
    default void messagesExchanged(AgentMessages messages) {}
}
