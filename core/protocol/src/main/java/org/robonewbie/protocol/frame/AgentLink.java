package org.robonewbie.protocol.frame;

import java.io.IOException;
import org.robonewbie.nao.state.Restorable;

/**
 * An agent's connection to a simulator, over TCP or within one process. In each cycle of 20 ms, one message is sent in each
 * direction.
 */
public interface AgentLink extends AutoCloseable {

    /**
     * Sends one message.
     *
     * @param message the message; the caller may reuse it after the call
     * @throws IOException if the connection is broken
     */
    void send(MessageBuffer message) throws IOException;

    /**
     * Waits for the next message from the simulator.
     *
     * @param message receives the message
     * @return false if the simulator has stopped and there are no more messages
     * @throws IOException if the connection is broken
     */
    boolean receive(MessageBuffer message) throws IOException;

    /**
     * Returns whether the simulator has continued without waiting for this agent.
     *
     * @return whether a message can be received immediately; always false for a simulator that waits for its agents
     * @throws IOException if the connection is broken
     */
    default boolean isMessageWaiting() throws IOException {
        return false;
    }

    /**
     * Registers the agent's state with a simulator in the same process. While the agent waits for its next message, the
     * simulator can save and restore this state together with the world. Other simulators ignore the call.
     *
     * @param agent the state of the agent
     */
    default void offerState(Restorable agent) {}

    /** Closes the connection, which removes the robot from the pitch. Closing again has no effect. */
    @Override
    void close();
}
