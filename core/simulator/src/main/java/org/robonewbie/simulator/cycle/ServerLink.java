package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.MessageBuffer;

/** The simulator's end of an agent's connection. No method waits. */
public interface ServerLink {

    /** The reason of an ordinary end. */
    String HAS_LEFT = "has left.";

    /**
     * Takes the next complete message that has arrived.
     *
     * @param message takes the message
     * @return false if none is there
     */
    boolean poll(MessageBuffer message);

    /**
     * Sends a message, or throws it away if the agent has not yet taken the former ones.
     *
     * @param message the message
     * @return false if it was thrown away
     */
    boolean offer(MessageBuffer message);

    /** {@return whether the agent is still connected; false once the connection has ended from either side} */
    boolean isOpen();

    /** {@return why the connection has ended, as part of a sentence such as "has left"} */
    String closingReason();

    /** Ends the connection. */
    void close();

    /** {@return whether the agent runs in this process, without a socket; such an agent is awaited as long as it lives} */
    boolean isLocal();

    /** {@return the address of the other end, such as "at 127.0.0.1:4711"} */
    String address();

    /** {@return the team to which the robot of this connection belongs, whatever the agent says; empty if it may choose} */
    default Optional<String> team() {
        return Optional.empty();
    }

    /**
     * Gives the messages that the agent has not taken yet, where they can be saved with the world.
     *
     * @return copies of the messages, the oldest first; none where they are out of reach, as in a socket
     */
    default List<byte[]> messagesForAgent() {
        return List.of();
    }

    /**
     * Replaces the messages that the agent has not taken yet, where {@link #messagesForAgent} gives them.
     *
     * @param messages the messages, the oldest first
     */
    default void setMessagesForAgent(List<byte[]> messages) {}

    /** {@return the agent's own state, to be saved with the world; empty where it is out of reach} */
    default Optional<Restorable> agentState() {
        return Optional.empty();
    }
}
