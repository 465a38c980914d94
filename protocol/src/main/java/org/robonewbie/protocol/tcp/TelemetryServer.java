package org.robonewbie.protocol.tcp;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.protocol.telemetry.TelemetryLine;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/**
 * Receives the telemetry of robots in other processes of this computer and passes it on to a {@link TelemetrySink}. Lines that
 * are not telemetry are ignored.
 */
public final class TelemetryServer implements AutoCloseable {

    private static final int ABOVE_AGENT_PORT = 200;
    private static final int HIGHEST_PORT = 65_535;
    private static final int MOST_CONNECTIONS = 64;
    private static final int LONGEST_LINE = 200_000;

    private final ServerSocket socket;
    private final TelemetrySink sink;
    private final Set<Socket> robots = ConcurrentHashMap.newKeySet();

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
        close(socket);
        robots.forEach(TelemetryServer::close);
    }

    private void welcome() {
        while (!socket.isClosed()) {
            try {
                Socket robot = socket.accept();
                if (robots.size() < MOST_CONNECTIONS && robots.add(robot)) {
                    start(() -> listen(robot));
                } else {
                    robot.close();
                }
            } catch (IOException closed) {
                // the loop sees whether this socket was closed or only a robot's
            }
        }
    }

    private void listen(Socket robot) {
        try (robot;
                Reader reader =
                        new BufferedReader(new InputStreamReader(robot.getInputStream(), StandardCharsets.UTF_8))) {
            StringBuilder line = new StringBuilder();
            for (int sign = reader.read(); sign >= 0 && line.length() < LONGEST_LINE; sign = reader.read()) {
                if (sign == '\n') {
                    TelemetryLine.read(line.toString()).ifPresent(sink::accept);
                    line.setLength(0);
                } else {
                    line.append((char) sign);
                }
            }
        } catch (IOException gone) {
            // a robot that leaves in the middle of a line has nothing more to say
        } finally {
            robots.remove(robot);
        }
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "telemetry-server");
        thread.setDaemon(true);
        thread.start();
    }

    private static void close(AutoCloseable closeable) {
        try {
            closeable.close();
        } catch (Exception alreadyGone) {
            // closed is closed
        }
    }
}
