package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.robonewbie.protocol.telemetry.NumberWish;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/**
 * Receives the telemetry of robots in other processes of this computer and passes it on to a {@link TelemetrySink}; hands back
 * what people want of the robots' numbers. Lines that are not telemetry are ignored.
 */
public final class TelemetryServer implements AutoCloseable {

    private static final int ABOVE_AGENT_PORT = 200;
    private static final int HIGHEST_PORT = 65_535;
    private static final int MAX_CONNECTIONS = 64;

    private final ServerSocket socket;
    private final TelemetrySink sink;
    private final Set<TelemetryVisitor> visitors = ConcurrentHashMap.newKeySet();
    private final Predicate<NumberWish> messenger = this::handOn;

    private TelemetryServer(ServerSocket socket, TelemetrySink sink) {
        this.socket = socket;
        this.sink = sink;
    }

    /**
     * Returns the port at which a simulator receives telemetry.
     *
     * @param agentPort agent port of the simulator, 3100 by default
     * @return the telemetry port, 3300 by default
     */
    public static int portFor(int agentPort) {
        int above = agentPort + ABOVE_AGENT_PORT;
        return above <= HIGHEST_PORT ? above : agentPort - ABOVE_AGENT_PORT;
    }

    /**
     * Starts listening.
     *
     * @param port TCP port on 127.0.0.1, see {@link #portFor}; 0 takes any free one
     * @param sink receives the telemetry of all robots, in threads of this server
     * @return the open server
     * @throws IOException if the port is in use
     */
    public static TelemetryServer open(int port, TelemetrySink sink) throws IOException {
        ServerSocket socket = new ServerSocket(port, 0, InetAddress.getLoopbackAddress());
        TelemetryServer server = new TelemetryServer(socket, sink);
        sink.wishes().ifPresent(wishes -> wishes.sendBy(server.messenger));
        start(server::welcome);
        return server;
    }

    /** {@return the TCP port on 127.0.0.1 on which the server listens} */
    public int port() {
        return socket.getLocalPort();
    }

    /** Closes all connections. */
    @Override
    public void close() {
        sink.wishes().ifPresent(wishes -> wishes.sendNoMoreBy(messenger));
        try {
            socket.close();
        } catch (IOException alreadyGone) {
            // closed is closed
        }
        visitors.forEach(TelemetryVisitor::close);
    }

    private void welcome() {
        while (!socket.isClosed()) {
            try {
                TelemetryVisitor visitor = new TelemetryVisitor(socket.accept(), sink);
                if (visitors.size() < MAX_CONNECTIONS && visitors.add(visitor)) {
                    start(() -> listen(visitor));
                } else {
                    visitor.close();
                }
            } catch (IOException closed) {
                // the loop sees whether this socket was closed or only a robot's
            }
        }
    }

    private void listen(TelemetryVisitor visitor) {
        try {
            visitor.listen();
        } finally {
            visitors.remove(visitor);
        }
    }

    private boolean handOn(NumberWish wish) {
        return visitors.stream().anyMatch(visitor -> visitor.take(wish));
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "telemetry-server");
        thread.setDaemon(true);
        thread.start();
    }
}
