package org.robonewbie.learning.gym;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.function.Consumer;

/**
 * Offers the tasks to learning programs in other languages, through a TCP port of this computer only. Each connection has
 * environments of its own, so that several programs do not disturb each other. The messages are described in
 * docs/gym-protocol.md; {@code python/} speaks them.
 */
public final class GymServer implements AutoCloseable {

    private static final byte[] LOOPBACK = {127, 0, 0, 1};

    private final ServerSocket socket;
    private final Consumer<String> console;

    private GymServer(ServerSocket socket, Consumer<String> console) {
        this.socket = socket;
        this.console = console;
    }

    /**
     * Opens the port on 127.0.0.1 and begins to serve.
     *
     * @param port the port, 0 for any free one
     * @param console where it tells people what went wrong
     * @return the server
     * @throws IOException if the port is in use
     */
    public static GymServer open(int port, Consumer<String> console) throws IOException {
        GymServer server = new GymServer(new ServerSocket(port, 50, InetAddress.getByAddress(LOOPBACK)), console);
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
                console.accept("No more learning programs can connect: " + closed.getMessage());
            }
        }
    }

    private void serve(Socket client) {
        try (client) {
            client.setTcpNoDelay(true);
            new GymConnection(
                            new DataInputStream(new BufferedInputStream(client.getInputStream())),
                            new DataOutputStream(new BufferedOutputStream(client.getOutputStream())))
                    .serve();
        } catch (IOException broken) {
            console.accept("A learning program is no longer served: " + broken.getMessage());
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
