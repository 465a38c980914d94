package org.robonewbie.simulator.server;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;

/**
 * A stepped simulator with a TCP port, for comparing messages sent over a socket with the true state of the world. Not thread-safe.
 *
 * <pre>{@code
 * try (SteppedServer server = SteppedServer.start(settings, Console.standard())) {
 *     AgentLink agent = server.connect();
 *     agent.send(message);
 *     server.cycle();
 * }
 * }</pre>
 */
public final class SteppedServer implements AutoCloseable {

    private static final long WAITING_MILLISECONDS = 100;

    private final SteppedSimulator simulator;
    private final AgentPort port;
    private int connected;

    private SteppedServer(SteppedSimulator simulator, AgentPort port) {
        this.simulator = simulator;
        this.port = port;
    }

    /**
     * Opens any free port and creates the simulator.
     *
     * @param settings the world to simulate; should be synchronous
     * @param console output for messages to the user
     * @return the server, which has not run a cycle yet
     * @throws IOException if no port can be opened
     */
    public static SteppedServer start(WorldSettings settings, Console console) throws IOException {
        AgentPort port =
                AgentPort.open(SimulatorSettings.of(settings).withAgentPort(0).agents(), console);
        return new SteppedServer(SteppedSimulator.start(settings, console), port);
    }

    /** {@return the simulator, for in-process agents} */
    public SteppedSimulator simulator() {
        return simulator;
    }

    /**
     * Connects an agent through the TCP port.
     *
     * @return the agent's end of the connection
     * @throws IOException if the connection fails
     */
    public AgentLink connect() throws IOException {
        AgentLink link = TcpAgentLink.connect(SimulatorSettings.LOCALHOST, port.number(Optional.empty()));
        int before = connected;
        while (connected == before) {
            listen(WAITING_MILLISECONDS);
        }
        return link;
    }

    /** Waits until each agent has sent a message ending with {@code (syn)}, then runs one cycle. */
    public void cycle() {
        listen(0);
        while (!simulator.isReady()) {
            listen(WAITING_MILLISECONDS);
        }
        simulator.cycle();
    }

    @Override
    public void close() {
        simulator.close();
        port.close();
    }

    private void listen(long milliseconds) {
        port.listen(milliseconds, link -> {
            simulator.connect(link);
            connected++;
        });
    }
}
