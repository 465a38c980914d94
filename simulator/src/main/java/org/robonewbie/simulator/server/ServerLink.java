package org.robonewbie.simulator.server;

import org.robonewbie.protocol.frame.MessageBuffer;

/** The simulator's end of an agent's connection. No method waits. */
interface ServerLink {

    /** The reason of an end that nobody has to think about. */
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

    /**
     * Tells whether the agent is still there.
     *
     * @return false once the connection has ended from either side
     */
    boolean isOpen();

    /**
     * Says why the connection has ended.
     *
     * @return part of a sentence such as "has left"
     */
    String closingReason();

    /** Ends the connection. */
    void close();

    /**
     * Tells whether the agent runs in this process; such an agent is waited for as long as it lives.
     *
     * @return true without a socket
     */
    boolean isLocal();

    /**
     * Tells where the other end is.
     *
     * @return such as "at 127.0.0.1:4711"
     */
    String address();
}
