package org.robonewbie.simulator.server;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.cycle.SimulationCycle;

/** Admits new agents, reads their messages, and blocks the simulation thread until there is new input. */
final class AgentAcceptor {

    private static final int MAX_AGENTS = 256;
    private static final int MAX_CHUNKS = 100;

    private final AgentPort port;
    private final SimulationCycle cycle;
    private final SimulatorSettings settings;
    private final Queue<LocalLink> newLinks = new ConcurrentLinkedQueue<>();
    private volatile boolean wakeUpRequested;
    private volatile boolean waiting;
    private volatile boolean closed;

    AgentAcceptor(AgentPort port, SimulationCycle cycle, SimulatorSettings settings) {
        this.port = port;
        this.cycle = cycle;
        this.settings = settings;
    }

    /** Connects an in-process agent. Thread-safe; agents are numbered in the order of these calls. */
    AgentLink connect() {
        LocalLink link = new LocalLink(this::wakeUp);
        newLinks.add(link);
        wakeUp();
        if (closed) {
            link.close();
        }
        return link;
    }

    /** Signals new input. Thread-safe. */
    void wakeUp() {
        wakeUpRequested = true;
        if (waiting) {
            port.wakeUp();
        }
    }

    /** Admits new agents and reads the messages that have arrived, without waiting. */
    void receive() {
        wakeUpRequested = false;
        admit(0);
        cycle.readMessages();
    }

    /**
     * Reads everything that has arrived, such as an agent's last message and its disconnection. A limit protects against
     * agents that never stop sending.
     */
    void receiveAll() {
        receive();
        for (int chunks = 0; chunks < MAX_CHUNKS && admit(0); chunks++) {
            cycle.readMessages();
        }
    }

    /** Waits for new input; returns whether there is any. */
    boolean await(long milliseconds) {
        waiting = true;
        boolean hasInput = wakeUpRequested || admit(milliseconds) || wakeUpRequested;
        waiting = false;
        return hasInput;
    }

    void close() {
        closed = true;
        port.close();
        newLinks.forEach(LocalLink::close);
    }

    /** Admits new agents; returns whether there was activity on the port. */
    private boolean admit(long milliseconds) {
        boolean active = port.listen(milliseconds, this::admit);
        for (LocalLink link = newLinks.poll(); link != null; link = newLinks.poll()) {
            cycle.connect(link.serverEnd(), true);
        }
        return active;
    }

    private void admit(TcpServerLink link) {
        if (cycle.agents().size() >= MAX_AGENTS) {
            link.close();
            cycle.reportRefused(link, MAX_AGENTS);
        } else {
            cycle.connect(link, settings.agents().awaited() > 0 && cycle.cycle() == 0);
        }
    }
}
