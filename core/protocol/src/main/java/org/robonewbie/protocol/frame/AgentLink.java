package org.robonewbie.protocol.frame;

import java.io.IOException;
import org.robonewbie.nao.state.Restorable;

/**
 * An agent's connection to a simulator, over TCP or within one process. One message is exchanged each way per cycle of 20 ms.
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
     * Waits for the next message of the simulator.
     *
     * @param message receives the message
     * @return false if the simulator has ended and there are no more messages
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
     * Registers the agent's state with a simulator in the same process, which saves and restores it together with the world while
     * the agent waits for its next message. Other simulators ignore it.
     *
     * @param agent the state of the agent
     */
    default void offerState(Restorable agent) {}

    /** Closes the connection, which removes the robot from the pitch. Closing again has no effect. */
    @Override
    void close();
}
