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
        return isServerOn(port) ? new Server(THIS_COMPUTER, port) : startOwn(options, port, robots);
    }

    /** Connects one more robot. */
    abstract AgentLink connect() throws IOException;

    /** Says in one sentence where this is. */
    abstract String description();

    /** Whether the simulator itself ends the run after the wanted time. */
    abstract boolean endsByItself();

    /** Ends an own simulator. */
    @Override
    public abstract void close();

    private static Home join(Options options) {
        Server server =
                new Server(options.host().orElse(THIS_COMPUTER), options.port().orElse(USUAL_PORT));
        try {
            server.connect().close();
            return server;
        } catch (IOException nobody) {
            throw new StartUpException(String.valueOf(nobody.getMessage()));
        }
    }

    private static boolean isServerOn(int port) {
        try {
            TcpAgentLink.connect(THIS_COMPUTER, port).close();
            return true;
        } catch (IOException nobody) {
            return false;
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

        Server(String host, int port) {
            this.host = host;
            this.port = port;
        }

        @Override
        AgentLink connect() throws IOException {
            return TcpAgentLink.connect(host, port);
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
            // the server belongs to somebody else
        }
    }
}
