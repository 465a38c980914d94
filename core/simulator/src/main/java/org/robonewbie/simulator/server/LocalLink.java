package org.robonewbie.simulator.server;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.Optional;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.cycle.ServerLink;

/** An in-process connection between an agent and the simulator, made of two queues. */
final class LocalLink implements AgentLink {

    private final MessageQueue toSimulator = new MessageQueue();
    private final MessageQueue toAgent = new MessageQueue();
    private final Runnable wakeUp;
    private final ServerEnd serverEnd = new ServerEnd();
    private volatile Optional<Restorable> agentState = Optional.empty();

    /** Creates a connection that calls {@code wakeUp} on the agent's thread after each message for the simulator. */
    LocalLink(Runnable wakeUp) {
        this.wakeUp = wakeUp;
    }

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
        wakeUp.run();
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
        wakeUp.run();
    }

    private static IOException interrupted() {
        Thread.currentThread().interrupt();
        return new InterruptedIOException("The agent's thread was interrupted while communicating with the simulator.");
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
        public void close() {
            toSimulator.close();
            toAgent.close();
        }

        @Override
        public Optional<Restorable> agentState() {
            return agentState;
        }
    }
}
