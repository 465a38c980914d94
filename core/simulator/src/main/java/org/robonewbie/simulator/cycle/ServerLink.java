package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * The simulator's end of an agent's connection. All methods are non-blocking. The default implementations are for an
 * in-process agent.
 */
public interface ServerLink {

    /** The {@link #closingReason} of an agent that disconnects. */
    String HAS_LEFT = "has left.";

    /**
     * Receives the next complete message.
     *
     * @param message receives the message
     * @return false if none has arrived
     */
    boolean poll(MessageBuffer message);

    /**
     * Sends a message, or drops it if the agent has not read the previous ones.
     *
     * @param message the message
     * @return false if it was dropped
     */
    boolean offer(MessageBuffer message);

    /** {@return whether the connection is open; false once either side has closed it} */
    boolean isOpen();

    /** {@return why the connection was closed, as a predicate whose subject is the agent, such as "has left."} */
    default String closingReason() {
        return HAS_LEFT;
    }

    /** Closes the connection. */
    void close();

    /** {@return whether the agent runs in this process, without a socket; sync mode never drops such an agent} */
    default boolean isLocal() {
        return true;
    }

    /** {@return the address of the other end, such as "at 127.0.0.1:4711"} */
    default String address() {
        return "in this process";
    }

    /** {@return the team of this connection's robot, whichever team the agent requests; empty if the agent may choose} */
    default Optional<String> team() {
        return Optional.empty();
    }

    /**
     * Returns the messages that the agent has not read yet, to be saved with the world.
     *
     * @return copies of the messages, oldest first; empty if they are not accessible, as in a socket
     */
    default List<byte[]> messagesForAgent() {
        return List.of();
    }

    /**
     * Replaces the messages that the agent has not read yet, if {@link #messagesForAgent} can access them.
     *
     * @param messages the messages, oldest first
     */
    default void setMessagesForAgent(List<byte[]> messages) {}

    /** {@return the agent's own state, to be saved with the world; empty if it is not accessible} */
    default Optional<Restorable> agentState() {
        return Optional.empty();
    }
}
