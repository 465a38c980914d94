package org.robonewbie.agent.running;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.robonewbie.nao.file.PathEncoding;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.tcp.TcpAgentLink;
import org.robonewbie.protocol.tcp.TelemetryClient;
import org.robonewbie.protocol.tcp.TelemetryServer;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** Connection from a program's robots to their simulator: an embedded one, or a server that they join. */
public final class SimulatorConnection implements AutoCloseable {

    private static final String ALREADY_RUNNING =
            ", which is already running. Watch it in the studio at the address shown in the terminal where it was"
                    + " started. To start a new one instead, stop this one first, or add --seed 1.";

    private final boolean server;
    private final String place;
    private final String description;
    private final TelemetrySink telemetry;
    private final Connector connector;
    private final Runnable onClose;

    @FunctionalInterface
    private interface Connector {
        AgentLink connect() throws IOException;
    }

    private SimulatorConnection(
            boolean server,
            String place,
            String description,
            TelemetrySink telemetry,
            Connector connector,
            Runnable onClose) {
        this.server = server;
        this.place = place;
        this.description = description;
        this.telemetry = telemetry;
        this.connector = connector;
        this.onClose = onClose;
    }

    /**
     * Connects to a server or starts an embedded simulator. If either is acceptable, prefers the server.
     *
     * @param wanted the simulator to connect to
     * @return the connection
     * @throws IOException if there is no such simulator; the message is a sentence for the user
     */
    public static SimulatorConnection open(WantedSimulator wanted) throws IOException {
        Optional<String> unreadable = PathEncoding.problem();
        if (unreadable.isPresent()) {
            throw new IOException(unreadable.get());
        }
        return switch (wanted.kind()) {
            case SERVER -> join(wanted, "");
            case OWN -> start(wanted);
            case ANY -> joinOrStart(wanted);
        };
    }

    /**
     * Wraps an open connection of a single robot.
     *
     * @param link the robot's end of the connection
     * @return the connection
     */
    public static SimulatorConnection of(AgentLink link) {
        return new SimulatorConnection(
                false, "the simulator", "Playing over an open connection", TelemetrySink.NONE, () -> link, link::close);
    }

    private static SimulatorConnection joinOrStart(WantedSimulator wanted) throws IOException {
        try {
            return join(wanted, ALREADY_RUNNING);
        } catch (IOException noServer) {
            return start(wanted);
        }
    }

    private static SimulatorConnection join(WantedSimulator wanted, String advice) throws IOException {
        String host = wanted.host();
        int port = wanted.port();
        Deque<AgentLink> first = new ArrayDeque<>(List.of(TcpAgentLink.connect(host, port)));
        TelemetryClient telemetry = TelemetryClient.open(TelemetryServer.portFor(port));
        String place = host + ":" + port;
        return new SimulatorConnection(
                true,
                place,
                "Joining the server at " + place + advice,
                telemetry,
                () -> first.isEmpty() ? TcpAgentLink.connect(host, port) : first.remove(),
                () -> {
                    first.forEach(AgentLink::close);
                    telemetry.close();
                });
    }

    private static SimulatorConnection start(WantedSimulator wanted) throws IOException {
        String robot = wanted.own().robot();
        Optional<SimulatorProvider> provider = ServiceLoader.load(SimulatorProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(each -> each.has(robot))
                .findFirst();
        if (provider.isEmpty()) {
            throw new IOException("No simulator answers at " + wanted.host() + ":" + wanted.port()
                    + ", and this program has no embedded one: start one with \"robonewbie simulator\", or add"
                    + " robonewbie-simulator to the class path.");
        }
        try {
            EmbeddedSimulator simulator = provider.get().start(wanted.own());
            String studio = simulator
                    .studioAddress()
                    .map(address -> ". Watch it at " + address)
                    .orElse("");
            return new SimulatorConnection(
                    simulator.isServer(),
                    "the simulator",
                    simulator.description() + studio,
                    simulator.telemetry(),
                    simulator::connect,
                    simulator::close);
        } catch (IOException impossible) {
            throw new IOException("The simulator cannot start: " + impossible.getMessage(), impossible);
        } catch (InvalidPathException refused) {
            throw new IOException(PathEncoding.explain(refused), refused);
        }
    }

    /**
     * Connects one more robot.
     *
     * @return the robot's end of the connection
     * @throws IOException if the simulator does not respond
     */
    public AgentLink connect() throws IOException {
        return connector.connect();
    }

    /** {@return the receiver of the robots' telemetry} */
    public TelemetrySink telemetry() {
        return telemetry;
    }

    /** {@return a sentence that describes the simulator, for users} */
    public String description() {
        return description;
    }

    /** {@return the address of the simulator, for messages} */
    public String place() {
        return place;
    }

    /**
     * {@return whether the simulator is a server, which never ends the run on its own and should be joined by one robot
     * at a time}
     */
    public boolean isServer() {
        return server;
    }

    /** Closes the connection, and stops the simulator if it is embedded. */
    @Override
    public void close() {
        onClose.run();
    }
}
