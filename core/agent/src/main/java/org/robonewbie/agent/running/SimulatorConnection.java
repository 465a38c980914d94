package org.robonewbie.agent.running;

import java.io.IOException;
import java.nio.file.InvalidPathException;
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

/** A connection to the simulator in which robots live: one of this process, or a server that they join. */
public abstract sealed class SimulatorConnection implements AutoCloseable {

    private SimulatorConnection() {}

    /**
     * Connects to the named server, starts a simulator, or prefers the server on this computer to a simulator of its own.
     *
     * @param wanted which simulator
     * @return the connection
     * @throws IOException if there is no such simulator; the message is a sentence for the user
     */
    public static SimulatorConnection open(WantedSimulator wanted) throws IOException {
        Optional<String> unreadable = PathEncoding.problem();
        if (unreadable.isPresent()) {
            throw new IOException(unreadable.get());
        }
        return switch (wanted.kind()) {
            case SERVER -> Server.join(wanted.host(), wanted.port(), "");
            case OWN -> startOwn(wanted);
            case ANY -> joinOrStart(wanted);
        };
    }

    /**
     * Uses a connection that is already open, for one robot.
     *
     * @param link the robot's end of the connection
     * @return the connection
     */
    public static SimulatorConnection of(AgentLink link) {
        return new Given(link);
    }

    /**
     * Connects one more robot.
     *
     * @return the robot's end of the connection
     * @throws IOException if the simulator does not answer
     */
    public abstract AgentLink connect() throws IOException;

    /** {@return the receiver of what the robots think} */
    public abstract TelemetrySink telemetry();

    /** {@return one sentence that says where this is} */
    public abstract String description();

    /** {@return where it listens, in a few words} */
    public String place() {
        return "the simulator";
    }

    /** {@return whether the simulator itself ends the run after the wanted time} */
    public abstract boolean endsByItself();

    /** {@return whether the robots of a program should join one after another} */
    public boolean admitsOneByOne() {
        return false;
    }

    /** Ends the connection, and the simulator if it is one of this process. */
    @Override
    public abstract void close();

    /** For a user who does not expect another simulator. */
    private static final String RUNS_ALREADY =
            ", which runs already. Watch it in the studio whose address stands in the"
                    + " terminal where it was started; for a fresh start end it there first, or add --seed 1.";

    private static SimulatorConnection joinOrStart(WantedSimulator wanted) throws IOException {
        try {
            return Server.join(wanted.host(), wanted.port(), RUNS_ALREADY);
        } catch (IOException noServer) {
            return startOwn(wanted);
        }
    }

    private static SimulatorConnection startOwn(WantedSimulator wanted) throws IOException {
        Optional<SimulatorProvider> provider =
                ServiceLoader.load(SimulatorProvider.class).findFirst();
        if (provider.isEmpty()) {
            throw new IOException("No simulator answers at " + wanted.host() + ":" + wanted.port()
                    + ", and this program has none of its own: start one with \"robonewbie simulator\", or add"
                    + " robonewbie-simulator to the class path.");
        }
        try {
            return new Own(provider.get().start(wanted.own()));
        } catch (IOException impossible) {
            throw new IOException("The simulator cannot start: " + impossible.getMessage(), impossible);
        } catch (InvalidPathException refused) {
            throw new IOException(PathEncoding.explain(refused), refused);
        }
    }

    /** A simulator of this process. */
    static final class Own extends SimulatorConnection {

        private final EmbeddedSimulator simulator;

        Own(EmbeddedSimulator simulator) {
            this.simulator = simulator;
        }

        @Override
        public AgentLink connect() {
            return simulator.connect();
        }

        @Override
        public TelemetrySink telemetry() {
            return simulator.telemetry();
        }

        @Override
        public String description() {
            return "Own simulator, agent port " + simulator.agentPort()
                    + simulator
                            .studioAddress()
                            .map(address -> ". Watch it at " + address)
                            .orElse("");
        }

        @Override
        public boolean endsByItself() {
            return true;
        }

        @Override
        public void close() {
            simulator.close();
        }
    }

    /** A server somewhere else. */
    static final class Server extends SimulatorConnection {

        private final String host;
        private final int port;
        private final String advice;
        private final TelemetryClient telemetry;
        private Optional<AgentLink> firstLink;

        private Server(String host, int port, String advice, AgentLink firstLink) {
            this.advice = advice;
            this.host = host;
            this.port = port;
            this.firstLink = Optional.of(firstLink);
            this.telemetry = TelemetryClient.open(TelemetryServer.portFor(port));
        }

        static Server join(String host, int port, String advice) throws IOException {
            return new Server(host, port, advice, TcpAgentLink.connect(host, port));
        }

        @Override
        public AgentLink connect() throws IOException {
            Optional<AgentLink> link = firstLink;
            firstLink = Optional.empty();
            return link.isPresent() ? link.get() : TcpAgentLink.connect(host, port);
        }

        @Override
        public TelemetrySink telemetry() {
            return telemetry;
        }

        @Override
        public String description() {
            return "Joins the server at " + place() + advice;
        }

        @Override
        public String place() {
            return host + ":" + port;
        }

        @Override
        public boolean endsByItself() {
            return false;
        }

        @Override
        public boolean admitsOneByOne() {
            return true;
        }

        @Override
        public void close() {
            firstLink.ifPresent(AgentLink::close);
            telemetry.close();
        }
    }

    /** A connection that was opened elsewhere, for one robot. */
    static final class Given extends SimulatorConnection {

        private final AgentLink link;

        Given(AgentLink link) {
            this.link = link;
        }

        @Override
        public AgentLink connect() {
            return link;
        }

        @Override
        public TelemetrySink telemetry() {
            return TelemetrySink.NONE;
        }

        @Override
        public String description() {
            return "Plays where it was connected";
        }

        @Override
        public boolean endsByItself() {
            return true;
        }

        @Override
        public void close() {
            link.close();
        }
    }
}
