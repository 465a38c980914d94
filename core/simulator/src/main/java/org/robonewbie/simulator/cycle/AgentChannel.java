package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;

/** The message exchange with one agent: incoming commands, outgoing messages and synchronisation. */
public final class AgentChannel implements Restorable {

    /** Number of messages that an agent may leave unanswered in sync mode while it joins. */
    private static final int FREE_MESSAGES = 5;

    /** Maximum number of queued commands per cycle; a robot has only 24 hinges. */
    private static final int MAX_COMMANDS = 2000;

    /** Maximum number of bytes per cycle that are kept for observers. */
    private static final int MAX_KEPT_BYTES = 65_536;

    private final ServerLink link;
    private final boolean synchronous;
    private final boolean strict;
    private final RateLimitedLogger warnings;
    private final EffectorMessageReader reader = new EffectorMessageReader();
    private final MessageBuffer incoming = new MessageBuffer();
    private final MessageBuffer outgoing = new MessageBuffer();
    private List<EffectorCommand> commands = new ArrayList<>();
    private List<EffectorCommand> executed = new ArrayList<>();
    private MessageBuffer received = new MessageBuffer();
    private MessageBuffer executedMessage = new MessageBuffer();
    private boolean synchronised;
    private boolean everSynchronised;
    private boolean answered = true;
    private boolean spoken;
    private int generatedMessages;
    private long unansweredMessages;
    private boolean restored;

    /**
     * Creates the channel.
     *
     * @param synchronous whether the world runs in sync mode
     * @param strict whether sync mode waits for the agent from its first message on, as for awaited and in-process agents
     */
    AgentChannel(ServerLink link, boolean synchronous, boolean strict, Console console) {
        this.link = link;
        this.synchronous = synchronous;
        this.strict = strict;
        this.warnings = new RateLimitedLogger(console, "The agent " + link.address());
    }

    /** {@return the simulator's end of the connection} */
    public ServerLink link() {
        return link;
    }

    /** Reads the messages that have arrived. */
    void read() {
        while (link.poll(incoming)) {
            spoken = true;
            answered = true;
            if (received.length() < MAX_KEPT_BYTES) {
                received.append(incoming);
            }
            reader.read(incoming, this::take, this::warn);
        }
    }

    /** Removes and returns the queued commands in order of arrival. The list is valid until the next call. */
    List<EffectorCommand> takeCommands() {
        List<EffectorCommand> done = executed;
        executed = commands;
        commands = done;
        commands.clear();
        MessageBuffer last = executedMessage;
        executedMessage = received;
        received = last;
        received.clear();
        return executed;
    }

    /** {@return the agent's messages executed in this cycle, concatenated in order of arrival} */
    public MessageBuffer executedMessage() {
        return executedMessage;
    }

    List<EffectorCommand> executedCommands() {
        return executed;
    }

    /**
     * Returns whether the agent has disconnected. In sync mode, a disconnection is reported only when the agent's next
     * answer is due, so that a run does not depend on when it is detected.
     */
    boolean hasLeft() {
        return !link.isOpen() && !(synchronous && synchronised);
    }

    /** Returns whether the agent has ever sent a message. */
    boolean hasSpoken() {
        return spoken;
    }

    /** Returns whether sync mode need not wait for this agent. */
    boolean isSynchronised() {
        return synchronised
                || !link.isOpen()
                || (generatedMessages < FREE_MESSAGES && (!strict || hasAnsweredWithoutSyn()))
                || (!link.isLocal() && !spoken);
    }

    /**
     * Returns whether an agent in another process has answered, but never with {@code (syn)}; until its first
     * {@code (syn)}, any answer counts.
     */
    private boolean hasAnsweredWithoutSyn() {
        return !link.isLocal() && answered && !everSynchronised;
    }

    /**
     * Returns whether this agent is in another process and must join before a world in sync mode runs its first cycle.
     */
    boolean isAwaited() {
        return synchronous && strict && !link.isLocal();
    }

    /** Returns the cleared buffer for the next message. Call {@link #messageGenerated} when it is filled. */
    MessageBuffer emptyMessage() {
        outgoing.clear();
        return outgoing;
    }

    /** {@return the most recently generated message, empty before the first one} */
    public MessageBuffer newestMessage() {
        return outgoing;
    }

    void messageGenerated() {
        generatedMessages++;
    }

    /** Sends the most recently generated message, if any. */
    void send() {
        if (outgoing.length() == 0) {
            return;
        }
        if (!answered) {
            unansweredMessages++;
        }
        if (link.offer(outgoing) || !link.isOpen()) {
            synchronised = false;
            answered = false;
        } else {
            warn("slow", "does not read its messages fast enough; some are dropped.");
        }
    }

    /** {@return the number of messages that the agent answered before the next one was sent} */
    public long answeredMessages() {
        return Math.max(0, generatedMessages - unansweredMessages - 1);
    }

    /** Returns the number of messages that the agent did not answer before the next one was sent. */
    long unansweredMessages() {
        return unansweredMessages;
    }

    void warn(String kind, String sentence) {
        warnings.warn(kind, sentence);
    }

    private void warn(String problem) {
        warn(problem, "sent an invalid command. " + problem + ".");
    }

    private void take(EffectorCommand command) {
        if (command instanceof EffectorCommand.Synchronise) {
            synchronised = true;
            everSynchronised = true;
        } else if (commands.size() < MAX_COMMANDS) {
            commands.add(command);
        } else {
            warn("flood", "sends more than " + MAX_COMMANDS + " commands in one cycle; the rest are ignored.");
        }
    }

    @Override
    public void save(StateWriter out) {
        out.putAll(link.messagesForAgent(), message -> out.putBytes(message, message.length));
        out.putAll(commands, command -> SavedCommand.save(command, out));
        out.putBytes(outgoing.bytes(), outgoing.length());
        out.putBytes(received.bytes(), received.length());
        out.putBoolean(synchronised);
        out.putBoolean(everSynchronised);
        out.putBoolean(answered);
        out.putBoolean(spoken);
        out.putInt(generatedMessages);
        out.putLong(unansweredMessages);
        byte[] own = agentState();
        out.putBytes(own, own.length);
    }

    private byte[] agentState() {
        StateWriter own = new StateWriter();
        try {
            link.agentState().ifPresent(agent -> agent.save(own));
            return own.toBytes();
        } catch (RuntimeException mistake) {
            warn("save", "cannot save its state: " + mistake + ". It will not be restored.");
            return new byte[0];
        }
    }

    @Override
    public void restore(StateReader in) {
        // Unread messages belong to the state that is being replaced.
        while (link.poll(incoming)) {
            incoming.clear();
        }
        link.setMessagesForAgent(in.getAll(in::getBytes));
        commands.clear();
        commands.addAll(in.getAll(() -> SavedCommand.restore(in)));
        outgoing.set(in.getBytes());
        received.set(in.getBytes());
        executed.clear();
        executedMessage.clear();
        synchronised = in.getBoolean();
        everSynchronised = in.getBoolean();
        answered = in.getBoolean();
        spoken = in.getBoolean();
        generatedMessages = in.getInt();
        unansweredMessages = in.getLong();
        restored = isRestored(in.getBytes());
    }

    private boolean isRestored(byte[] own) {
        try {
            StateReader state = new StateReader(own);
            link.agentState().ifPresent(agent -> {
                agent.restore(state);
                state.finish();
            });
            return own.length > 0 && link.agentState().isPresent();
        } catch (RuntimeException mistake) {
            warn("restore", "cannot restore its saved state: " + mistake + ". It keeps its current memory.");
            return false;
        }
    }

    /** Returns whether the last {@link #restore} also restored the agent's own state. */
    boolean isRestored() {
        return restored;
    }
}
