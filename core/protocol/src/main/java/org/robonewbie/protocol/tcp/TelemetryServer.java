package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequest;

/**
 * Receives the telemetry of robots in other processes on this computer, passes it to a {@link TelemetrySink}, and forwards the
 * sink's tuning requests to the robots. Lines that are not telemetry are ignored.
 */
public final class TelemetryServer implements AutoCloseable {

    private static final int PORT_OFFSET = 200;
    private static final int MAX_PORT = 65_535;
    private static final int MAX_CONNECTIONS = 64;

    private final ServerSocket socket;
    private final TelemetrySink sink;
    private final Set<TelemetryConnection> connections = ConcurrentHashMap.newKeySet();
    private final Predicate<TuningRequest> forwarder = this::forward;

    private TelemetryServer(ServerSocket socket, TelemetrySink sink) {
        this.socket = socket;
        this.sink = sink;
    }

    /**
     * Returns the port on which a simulator receives telemetry.
     *
     * @param agentPort agent port of the simulator, 3100 by default
     * @return the telemetry port, 3300 by default
     */
    public static int portFor(int agentPort) {
        int above = agentPort + PORT_OFFSET;
        return above <= MAX_PORT ? above : agentPort - PORT_OFFSET;
    }

    /**
     * Starts listening.
     *
     * @param port TCP port on 127.0.0.1, see {@link #portFor}; 0 for any free port
     * @param sink receives the telemetry of all robots on threads of this server
     * @return the open server
     * @throws IOException if the port is in use
     */
    public static TelemetryServer open(int port, TelemetrySink sink) throws IOException {
        ServerSocket socket = new ServerSocket(port, 0, InetAddress.getLoopbackAddress());
        TelemetryServer server = new TelemetryServer(socket, sink);
        sink.tuningRequests().ifPresent(requests -> requests.addForwarder(server.forwarder));
        start(server::acceptConnections);
        return server;
    }

    /** {@return the TCP port on 127.0.0.1 on which the server listens} */
    public int port() {
        return socket.getLocalPort();
    }

    /** Closes all connections. */
    @Override
    public void close() {
        sink.tuningRequests().ifPresent(requests -> requests.removeForwarder(forwarder));
        try {
            socket.close();
        } catch (IOException ignored) {
            // the socket counts as closed anyway
        }
        connections.forEach(TelemetryConnection::close);
    }

    private void acceptConnections() {
        while (!socket.isClosed()) {
            try {
                TelemetryConnection connection = new TelemetryConnection(socket.accept(), sink);
                if (connections.size() < MAX_CONNECTIONS && connections.add(connection)) {
                    start(() -> receive(connection));
                } else {
                    connection.close();
                }
            } catch (IOException closed) {
                // the loop ends if the server's socket was closed, and continues if only a robot's socket was
            }
        }
    }

    private void receive(TelemetryConnection connection) {
        try {
            connection.receive();
        } finally {
            connections.remove(connection);
        }
    }

    private boolean forward(TuningRequest request) {
        return connections.stream().anyMatch(connection -> connection.forward(request));
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "telemetry-server");
        thread.setDaemon(true);
        thread.start();
    }
}
