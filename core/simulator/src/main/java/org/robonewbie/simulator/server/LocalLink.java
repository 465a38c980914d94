package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.Optional;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.cycle.ServerLink;

/** A connection between an agent and the simulator in the same process: two queues instead of a socket. */
final class LocalLink implements AgentLink {

    private final MessageQueue toSimulator = new MessageQueue();
    private final MessageQueue toAgent = new MessageQueue();
    private final Runnable doorbell;
    private final ServerEnd serverEnd = new ServerEnd();
    private volatile Optional<Restorable> agentState = Optional.empty();

    /**
     * Creates the connection.
     *
     * @param doorbell called after each message for the simulator, on the agent's thread
     */
    LocalLink(Runnable doorbell) {
        this.doorbell = doorbell;
    }

    /** {@return the simulator's end of this link} */
    ServerLink serverEnd() {
        return serverEnd;
    }

    @Override
    public void send(MessageBuffer message) throws IOException {
        try {
            toSimulator.put(message);
        } catch (InterruptedException e) {
            throw interrupted();
        }
        doorbell.run();
    }

    @Override
    public boolean receive(MessageBuffer message) throws IOException {
        try {
            return toAgent.take(message);
        } catch (InterruptedException e) {
            throw interrupted();
        }
    }

    @Override
    public void offerState(Restorable agent) {
        agentState = Optional.of(agent);
    }

    @Override
    public void close() {
        serverEnd.close();
        doorbell.run();
    }

    private static IOException interrupted() {
        Thread.currentThread().interrupt();
        return new InterruptedIOException("The agent's thread was interrupted while it talked to the simulator.");
    }

    private final class ServerEnd implements ServerLink {

        @Override
        public boolean poll(MessageBuffer message) {
            return toSimulator.poll(message);
        }

        @Override
        public boolean offer(MessageBuffer message) {
            return toAgent.offer(message) || toAgent.isClosed();
        }

        @Override
        public boolean isOpen() {
            return !toSimulator.isExhausted();
        }

        @Override
        public String closingReason() {
            return HAS_LEFT;
        }

        @Override
        public void close() {
            toSimulator.close();
            toAgent.close();
        }

        @Override
        public Optional<Restorable> agentState() {
            return agentState;
        }

        @Override
        public boolean isLocal() {
            return true;
        }

        @Override
        public String address() {
            return "in this process";
        }
    }
}
