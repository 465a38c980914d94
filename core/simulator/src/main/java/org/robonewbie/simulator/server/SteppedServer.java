package org.robonewbie.simulator.server;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;

/**
 * A stepped simulator with a TCP port: for measurements that compare what agents are told over a socket with what is true. Not for
 * several threads.
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

    private static final String THIS_COMPUTER = "127.0.0.1";
    private static final long WAITING_MILLISECONDS = 100;

    private final SteppedSimulator simulator;
    private final AgentPort port;
    private int connected;

    private SteppedServer(SteppedSimulator simulator, AgentPort port) {
        this.simulator = simulator;
        this.port = port;
    }

    /**
     * Opens any free port and prepares the pitch.
     *
     * @param settings what the world is like; it should be synchronous
     * @param console where it tells people what happens
     * @return the server, before its first cycle
     * @throws IOException if no port can be opened
     */
    public static SteppedServer start(WorldSettings settings, Console console) throws IOException {
        AgentPort port = AgentPort.open(THIS_COMPUTER, 0, console);
        return new SteppedServer(SteppedSimulator.start(settings, console), port);
    }

    /** {@return the simulator, to which agents of this thread connect directly} */
    public SteppedSimulator simulator() {
        return simulator;
    }

    /**
     * Connects an agent through the TCP port.
     *
     * @return the agent's end
     * @throws IOException if the connection fails
     */
    public AgentLink connect() throws IOException {
        AgentLink link = TcpAgentLink.connect(THIS_COMPUTER, port.number());
        int before = connected;
        while (connected == before) {
            listen(WAITING_MILLISECONDS);
        }
        return link;
    }

    /** Waits until each agent has sent an answer that ends with {@code (syn)}, then runs one cycle. */
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
