package org.robonewbie.learning.environment;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.function.Consumer;
import org.robonewbie.simulator.embedded.Viewer;

/**
 * TCP server on the loopback interface that offers environments to training programs in other languages. Each
 * connection has its own environments. docs/gym-protocol.md describes the messages; {@code research/python} is a
 * client.
 */
public final class EnvironmentServer implements AutoCloseable {

    private static final byte[] LOOPBACK = {127, 0, 0, 1};

    private final ServerSocket socket;
    private final ClassLoader classes;
    private final Viewer viewer;
    private final Consumer<String> console;

    private EnvironmentServer(ServerSocket socket, ClassLoader classes, Viewer viewer, Consumer<String> console) {
        this.socket = socket;
        this.classes = classes;
        this.viewer = viewer;
        this.console = console;
    }

    /**
     * Starts a server on 127.0.0.1.
     *
     * @param port the port; 0 for any free one
     * @param classes the class loader for custom tasks and measures
     * @param viewer shows an environment on request
     * @param console receives messages about broken connections
     * @return the server
     * @throws IOException if the port is in use
     */
    public static EnvironmentServer open(int port, ClassLoader classes, Viewer viewer, Consumer<String> console)
            throws IOException {
        ServerSocket socket = new ServerSocket(port, 50, InetAddress.getByAddress(LOOPBACK));
        EnvironmentServer server = new EnvironmentServer(socket, classes, viewer, console);
        daemon("gym server", server::accept);
        return server;
    }

    /** {@return the port on which the server listens} */
    public int port() {
        return socket.getLocalPort();
    }

    private void accept() {
        try {
            while (!socket.isClosed()) {
                Socket client = socket.accept();
                daemon("gym connection", () -> serve(client));
            }
        } catch (IOException closed) {
            if (!socket.isClosed()) {
                console.accept("The environment server accepts no more connections: " + closed.getMessage());
            }
        }
    }

    private void serve(Socket client) {
        try (client) {
            client.setTcpNoDelay(true);
            new EnvironmentConnection(
                            new DataInputStream(new BufferedInputStream(client.getInputStream())),
                            new DataOutputStream(new BufferedOutputStream(client.getOutputStream())),
                            classes,
                            viewer)
                    .serve();
        } catch (IOException broken) {
            console.accept("The connection to a learning program was closed: " + broken.getMessage());
        }
    }

    private static void daemon(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
