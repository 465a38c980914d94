package org.robonewbie.simulator.server;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.TcpAgentLink;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * A whole simulator without thread and clock, whose owner calls for each cycle and may look into the world between two: for
 * measurements that compare what agents are told with what is true. Not for several threads.
 *
 * <pre>{@code
 * try (SteppedSimulator simulator = SteppedSimulator.start(settings, Console.standard())) {
 *     AgentLink agent = simulator.connectOverTcp();
 *     agent.send(message);
 *     simulator.cycle();
 * }
 * }</pre>
 */
public final class SteppedSimulator implements AutoCloseable {

    private static final long WAITING_MILLISECONDS = 100;

    private final SimulationCycle cycle;
    private final AgentPort port;
    private final Reception reception;

    private SteppedSimulator(SimulationCycle cycle, AgentPort port, SimulatorSettings settings) {
        this.cycle = cycle;
        this.port = port;
        this.reception = new Reception(port, cycle, settings);
    }

    /**
     * Opens the port and prepares the pitch.
     *
     * @param settings what the simulator shall do; it should be synchronous
     * @param console where it tells people what happens
     * @return the simulator, before its first cycle
     * @throws IOException if the port is in use or the recording cannot be written; the message says what to do
     */
    public static SteppedSimulator start(SimulatorSettings settings, Console console) throws IOException {
        AgentPort port = AgentPort.open(settings.bindAddress(), settings.agentPort(), console);
        return new SteppedSimulator(SimulationCycle.begin(settings, console), port, settings);
    }

    /**
     * Connects an agent without a socket.
     *
     * @return the agent's end
     */
    public AgentLink connect() {
        AgentLink link = reception.connect();
        reception.receive();
        return link;
    }

    /**
     * Connects an agent through the TCP port.
     *
     * @return the agent's end
     * @throws IOException if the connection fails
     */
    public AgentLink connectOverTcp() throws IOException {
        AgentLink link = TcpAgentLink.connect("127.0.0.1", port.number());
        int agents = cycle.agents().size();
        while (cycle.agents().size() == agents) {
            reception.await(WAITING_MILLISECONDS);
        }
        return link;
    }

    /**
     * Waits until each agent has sent an answer that ends with {@code (syn)}, then runs one cycle. Each agent must have sent
     * something before.
     */
    public void cycle() {
        reception.receive();
        while (cycle.heardAgents() < cycle.agents().size()
                || cycle.unsynchronisedAgent().isPresent()) {
            reception.await(WAITING_MILLISECONDS);
            reception.receive();
        }
        cycle.run();
    }

    /**
     * Gives access to the world.
     *
     * @return the world with its robots in the order in which they were created
     */
    public SoccerWorld world() {
        return cycle.world();
    }

    /**
     * Gives access to the game.
     *
     * @return the match on this pitch
     */
    public Match match() {
        return cycle.match();
    }

    /**
     * Takes a picture of the world, as observers of a running simulation get it.
     *
     * @param paused whether the owner holds the world
     * @param speed simulated seconds per second, as the owner keeps it
     * @return the present state
     */
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return Snapshots.of(cycle, paused, speed, speed);
    }

    @Override
    public void close() {
        cycle.agents().forEach(agent -> agent.connection().link().close());
        reception.close();
        cycle.recorder().close();
    }
}
