package org.robonewbie.simulator.cycle;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * A connection between an agent and a simulation on the same thread. While the agent waits for a message, the simulation runs its
 * next cycle.
 */
final class SteppedLink implements AgentLink {

    private static final int CAPACITY = 64;

    private final Queue<MessageBuffer> toWorld = new ArrayDeque<>();
    private final Queue<MessageBuffer> toAgent = new ArrayDeque<>();
    private final Queue<MessageBuffer> spare = new ArrayDeque<>();
    private final Runnable nextCycle;
    private final ServerLink serverEnd = new ServerEnd();
    private Optional<Restorable> agentState = Optional.empty();
    private boolean closed;

    SteppedLink(Runnable nextCycle) {
        this.nextCycle = nextCycle;
    }

    ServerLink serverEnd() {
        return serverEnd;
    }

    @Override
    public void send(MessageBuffer message) {
        if (!closed) {
            put(message, toWorld);
        }
    }

    @Override
    public boolean receive(MessageBuffer message) {
        while (toAgent.isEmpty() && !closed) {
            nextCycle.run();
        }
        return take(toAgent, message);
    }

    @Override
    public boolean isMessageWaiting() {
        return !toAgent.isEmpty();
    }

    @Override
    public void offerState(Restorable agent) {
        agentState = Optional.of(agent);
    }

    @Override
    public void close() {
        closed = true;
    }

    private void put(MessageBuffer message, Queue<MessageBuffer> queue) {
        MessageBuffer copy = spare.isEmpty() ? new MessageBuffer() : spare.remove();
        copy.clear();
        copy.append(message);
        queue.add(copy);
    }

    private boolean take(Queue<MessageBuffer> queue, MessageBuffer message) {
        if (queue.isEmpty()) {
            return false;
        }
        MessageBuffer first = queue.remove();
        message.clear();
        message.append(first);
        spare.add(first);
        return true;
    }

    private final class ServerEnd implements ServerLink {

        @Override
        public List<byte[]> messagesForAgent() {
            return toAgent.stream()
                    .map(message -> Arrays.copyOf(message.bytes(), message.length()))
                    .toList();
        }

        @Override
        public void setMessagesForAgent(List<byte[]> messages) {
            toAgent.clear();
            for (byte[] bytes : messages) {
                MessageBuffer message = new MessageBuffer();
                message.set(bytes);
                toAgent.add(message);
            }
        }

        @Override
        public boolean poll(MessageBuffer message) {
            return take(toWorld, message);
        }

        @Override
        public boolean offer(MessageBuffer message) {
            if (!closed && toAgent.size() < CAPACITY) {
                put(message, toAgent);
                return true;
            }
            return closed;
        }

        @Override
        public boolean isOpen() {
            return !closed || !toWorld.isEmpty();
        }

        @Override
        public void close() {
            closed = true;
        }

        @Override
        public Optional<Restorable> agentState() {
            return agentState;
        }
    }
}
