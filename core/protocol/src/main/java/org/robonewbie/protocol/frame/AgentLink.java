package org.robonewbie.protocol.frame;

import java.io.IOException;
import org.robonewbie.nao.state.Restorable;

/**
 * An agent's connection to a simulator: one message travels each way per cycle of 20 ms, with the same text over TCP and within
 * one process.
 */
public interface AgentLink extends AutoCloseable {

    /**
     * Sends one message.
     *
     * @param message the message; it may be changed once this method has returned
     * @throws IOException if the connection is broken
     */
    void send(MessageBuffer message) throws IOException;

    /**
     * Waits for the next message of the simulator.
     *
     * @param message receives the message
     * @return false if the simulator has ended and no more messages will come
     * @throws IOException if the connection is broken
     */
    boolean receive(MessageBuffer message) throws IOException;

    /**
     * Returns whether the simulator has continued without waiting for this agent.
     *
     * @return whether a message can be received at once; always false for a simulator that waits for its agents
     * @throws IOException if the connection is broken
     */
    default boolean isMessageWaiting() throws IOException {
        return false;
    }

    /**
     * Offers the agent's own state to a simulator of the same process, which saves and restores it together with the world while
     * the agent waits for its next message. Other simulators never ask for it.
     *
     * @param agent the state of the agent
     */
    default void offerState(Restorable agent) {}

    /** Ends the connection; the robot leaves the pitch. Closing twice does nothing. */
    @Override
    void close();
}
