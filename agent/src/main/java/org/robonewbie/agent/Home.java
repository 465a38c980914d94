package org.robonewbie.agent;

import java.io.IOException;
import java.net.URI;
import java.util.Optional;
import java.util.ServiceLoader;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.TcpAgentLink;
import org.robonewbie.protocol.telemetry.TelemetryClient;
import org.robonewbie.protocol.telemetry.TelemetryServer;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** Where robots live: in a simulator of this process, or on a server that they join. */
abstract sealed class Home implements AutoCloseable {

    private static final String THIS_COMPUTER = "127.0.0.1";
    private static final int USUAL_PORT = 3100;

    /**
     * Finds or makes a home as the options say: the named server; else an own simulator if something is asked for that only an
     * own one can do; else the server on this computer if there is one; else an own simulator.
     *
     * @throws StartUpException if there is none
     */
    static Home find(Options options, int robots) {
        if (options.needsServer()) {
            return join(options);
        }
        if (options.needsOwnSimulator()) {
            return startOwn(options, options.port().orElse(0), robots);
        }
        int port = options.port().orElse(USUAL_PORT);
        try {
            return Server.join(THIS_COMPUTER, port);
        } catch (IOException nobody) {
            return startOwn(options, port, robots);
        }
    }

    /** Connects one more robot. */
    abstract AgentLink connect() throws IOException;

    /** Finds out who wants to know what the robots think. */
    abstract TelemetrySink telemetry();

    /** Says in one sentence where this is. */
    abstract String description();

    /** Whether the simulator itself ends the run after the wanted time. */
    abstract boolean endsByItself();

    /** Ends an own simulator. */
    @Override
    public abstract void close();

    private static Home join(Options options) {
        try {
            return Server.join(
                    options.host().orElse(THIS_COMPUTER), options.port().orElse(USUAL_PORT));
        } catch (IOException nobody) {
            throw new StartUpException(String.valueOf(nobody.getMessage()));
        }
    }

    private static Home startOwn(Options options, int port, int robots) {
        SimulatorProvider provider = ServiceLoader.load(SimulatorProvider.class)
                .findFirst()
                .orElseThrow(() -> new StartUpException("No simulator answers at " + THIS_COMPUTER + ":" + port
                        + ", and this program has none of its own: start one with \"robonewbie simulator\", or add"
                        + " robonewbie-simulator to the class path."));
        try {
            return new Own(provider.start(new SimulatorRequest(
                    port,
                    options.seed(),
                    options.isFast(),
                    options.seconds(),
                    options.isHeadless(),
                    !options.isNoBrowser() && !options.isHeadless(),
                    options.isTruth(),
                    options.report(),
                    options.record(),
                    Math.max(robots, options.waitFor()))));
        } catch (IOException impossible) {
            throw new StartUpException("The simulator cannot start: " + impossible.getMessage());
        }
    }

    /** A simulator of this process. */
    static final class Own extends Home {

        private final EmbeddedSimulator simulator;

        Own(EmbeddedSimulator simulator) {
            this.simulator = simulator;
        }

        @Override
        AgentLink connect() {
            return simulator.connect();
        }

        @Override
        TelemetrySink telemetry() {
            return simulator.telemetry();
        }

        @Override
        String description() {
            Optional<URI> studio = simulator.studioAddress();
            return "Own simulator, agent port " + simulator.agentPort()
                    + studio.map(address -> ". Watch it at " + address).orElse("");
        }

        @Override
        boolean endsByItself() {
            return true;
        }

        @Override
        public void close() {
            simulator.close();
        }
    }

    /** A server somewhere else. */
    static final class Server extends Home {

        private final String host;
        private final int port;
        private final TelemetryClient telemetry;
        private Optional<AgentLink> firstLink;

        private Server(String host, int port, AgentLink firstLink) {
            this.host = host;
            this.port = port;
            this.firstLink = Optional.of(firstLink);
            this.telemetry = TelemetryClient.open(TelemetryServer.portFor(port));
        }

        static Server join(String host, int port) throws IOException {
            return new Server(host, port, TcpAgentLink.connect(host, port));
        }

        @Override
        AgentLink connect() throws IOException {
            Optional<AgentLink> link = firstLink;
            firstLink = Optional.empty();
            return link.isPresent() ? link.get() : TcpAgentLink.connect(host, port);
        }

        @Override
        TelemetrySink telemetry() {
            return telemetry;
        }

        @Override
        String description() {
            return "Joins the server at " + host + ":" + port;
        }

        @Override
        boolean endsByItself() {
            return false;
        }

        @Override
        public void close() {
            firstLink.ifPresent(AgentLink::close);
            telemetry.close();
        }
    }

    /** A connection that somebody else has opened, for one robot. */
    static final class Given extends Home {

        private final AgentLink link;

        Given(AgentLink link) {
            this.link = link;
        }

        @Override
        AgentLink connect() {
            return link;
        }

        @Override
        TelemetrySink telemetry() {
            return TelemetrySink.NONE;
        }

        @Override
        String description() {
            return "Plays where it was connected";
        }

        @Override
        boolean endsByItself() {
            return true;
        }

        @Override
        public void close() {
            link.close();
        }
    }
}
