package org.robonewbie.simulator.server;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.simulator.cycle.SimulationCycle;

/** Takes in new agents and their messages, and lets the simulation sleep until there is something new. */
final class AgentAcceptor {

    private static final int MAXIMUM_AGENTS = 256;
    private static final int MAX_CHUNKS = 100;

    private final AgentPort port;
    private final SimulationCycle cycle;
    private final SimulatorSettings settings;
    private final Queue<LocalLink> newcomers = new ConcurrentLinkedQueue<>();
    private volatile boolean rung;
    private volatile boolean sleeping;
    private volatile boolean closed;

    AgentAcceptor(AgentPort port, SimulationCycle cycle, SimulatorSettings settings) {
        this.port = port;
        this.cycle = cycle;
        this.settings = settings;
    }

    /** {@return the TCP port at which agents join} */
    int portNumber() {
        return port.number();
    }

    /** Connects an agent of this process, from any thread; agents are numbered in the order of these calls. */
    AgentLink connect() {
        LocalLink link = new LocalLink(this::ring);
        newcomers.add(link);
        ring();
        if (closed) {
            link.close();
        }
        return link;
    }

    /** Signals that there is something new; may be called from any thread. */
    void ring() {
        rung = true;
        if (sleeping) {
            port.wakeUp();
        }
    }

    /** Takes in whoever and whatever has arrived, without waiting. */
    void receive() {
        rung = false;
        admit(0);
        cycle.readMessages();
    }

    /** Takes in all that has arrived, such as an agent's last answer and then its end, unless somebody sends without end. */
    void receiveAll() {
        receive();
        for (int chunks = 0; chunks < MAX_CHUNKS && admit(0); chunks++) {
            cycle.readMessages();
        }
    }

    /** Waits until there is something new; returns whether there is. */
    boolean await(long milliseconds) {
        sleeping = true;
        boolean news = rung || admit(milliseconds) || rung;
        sleeping = false;
        return news;
    }

    void close() {
        closed = true;
        port.close();
        newcomers.forEach(LocalLink::close);
    }

    /** Admits new agents; returns whether anything has happened at the port. */
    private boolean admit(long milliseconds) {
        boolean active = port.listen(milliseconds, this::admit);
        for (LocalLink link = newcomers.poll(); link != null; link = newcomers.poll()) {
            cycle.connect(link.serverEnd(), true);
        }
        return active;
    }

    private void admit(TcpServerLink link) {
        if (cycle.agents().size() >= MAXIMUM_AGENTS) {
            link.close();
            cycle.refused(link, MAXIMUM_AGENTS);
        } else {
            cycle.connect(link, settings.awaitedAgents() > 0 && cycle.cycle() == 0);
        }
    }
}
