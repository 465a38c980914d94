package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageReader;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;

/** The conversation with one agent: which commands have come, which message goes out, and whether it keeps in step. */
public final class AgentChannel implements Restorable {

    /** Messages after which an agent must answer each one in sync mode, so that it can join without. */
    private static final int FREE_MESSAGES = 5;

    /** Commands of one agent that are kept for one cycle; a robot has 24 hinges. */
    private static final int MAXIMUM_COMMANDS = 2000;

    /** Bytes of an agent's messages of one cycle that are kept for observers. */
    private static final int MAXIMUM_KEPT_BYTES = 65_536;

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
    private boolean heardOf;
    private int generatedMessages;
    private long unansweredMessages;
    private boolean restored;

    /**
     * Begins the conversation.
     *
     * @param link the connection
     * @param synchronous whether the world waits for agents
     * @param strict whether in sync mode the agent is waited for from the beginning, as those are that the world awaits
     *     before it begins and those within this process
     * @param console where to tell the agent's mistakes
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
            heardOf = true;
            answered = true;
            if (received.length() < MAXIMUM_KEPT_BYTES) {
                received.append(incoming);
            }
            reader.read(incoming, this::take, this::warn);
        }
    }

    /** Takes out the commands that have arrived, in their order; the list is valid until they are taken again. */
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

    /** {@return the agent's messages that were carried out in this cycle, one after the other, as they came} */
    public MessageBuffer executedMessage() {
        return executedMessage;
    }

    /** The commands that were executed in this cycle, until it is over. */
    List<EffectorCommand> executedCommands() {
        return executed;
    }

    /**
     * Whether the agent is gone. Its end is noticed only when its next answer is due, so that in sync mode it does not depend
     * on how quickly the end arrives.
     */
    boolean hasLeft() {
        return !link.isOpen() && !(synchronous && synchronised);
    }

    /** Whether the agent has ever sent anything. */
    boolean isHeardOf() {
        return heardOf;
    }

    /** Whether an agent has come through a team's door, or through none, and sent something. */
    boolean isHeardOf(Optional<String> team) {
        return heardOf && link.team().equals(team);
    }

    /** Whether in sync mode the world need not wait for this agent. */
    boolean isSynchronised() {
        return synchronised
                || !link.isOpen()
                || (generatedMessages < FREE_MESSAGES && (!strict || hasAnsweredInItsOwnWay()))
                || (!link.isLocal() && !heardOf);
    }

    /** Agents of other processes may join without {@code (syn)}; then any answer counts. */
    private boolean hasAnsweredInItsOwnWay() {
        return !link.isLocal() && answered && !everSynchronised;
    }

    /** Whether the agent, of another process, is one of those that a world in sync mode awaits before it begins. */
    boolean isAwaited() {
        return synchronous && strict && !link.isLocal();
    }

    /** The buffer for the next message, to be filled and announced by {@link #messageGenerated}. */
    MessageBuffer emptyMessage() {
        outgoing.clear();
        return outgoing;
    }

    /** {@return the message that was generated last, empty before the first one} */
    public MessageBuffer newestMessage() {
        return outgoing;
    }

    void messageGenerated() {
        generatedMessages++;
    }

    /** Sends the message that was generated last, if there is one. */
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
            warn("slow", "does not read its messages fast enough; some are thrown away.");
        }
    }

    /** {@return the number of messages that were answered before the next one was sent} */
    public long answeredMessages() {
        return Math.max(0, generatedMessages - unansweredMessages - 1);
    }

    /** The number of messages that were not answered before the next one was sent. */
    long unansweredMessages() {
        return unansweredMessages;
    }

    void warn(String kind, String sentence) {
        warnings.warn(kind, sentence);
    }

    private void warn(String problem) {
        warn(problem, "sent something that cannot be used. " + problem + ".");
    }

    private void take(EffectorCommand command) {
        if (command instanceof EffectorCommand.Synchronise) {
            synchronised = true;
            everSynchronised = true;
        } else if (commands.size() < MAXIMUM_COMMANDS) {
            commands.add(command);
        } else {
            warn("flood", "sends more than " + MAXIMUM_COMMANDS + " commands in one cycle; the rest is ignored.");
        }
    }

    /** Writes what has been read and not carried out, what is to be sent, and who has to answer. */
    @Override
    public void save(StateWriter out) {
        out.putAll(link.messagesForAgent(), message -> out.putBytes(message, message.length));
        out.putAll(commands, command -> SavedCommand.save(command, out));
        out.putBytes(outgoing.bytes(), outgoing.length());
        out.putBytes(received.bytes(), received.length());
        out.putBoolean(synchronised);
        out.putBoolean(everSynchronised);
        out.putBoolean(answered);
        out.putBoolean(heardOf);
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

    /** Takes on a state; what the agent has sent and was not read yet belongs to the past and is dropped. */
    @Override
    public void restore(StateReader in) {
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
        heardOf = in.getBoolean();
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
            warn("restore", "cannot take on its saved state: " + mistake + ". It goes on with what it remembers.");
            return false;
        }
    }

    /** Whether the agent itself has taken on its part of the state that was restored last. */
    boolean isRestored() {
        return restored;
    }
}
