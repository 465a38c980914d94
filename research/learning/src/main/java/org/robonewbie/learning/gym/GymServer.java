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
 * docs/gym-protocol.md; {@code research/python} speaks them.
 */
public final class GymServer implements AutoCloseable {

    private static final byte[] LOOPBACK = {127, 0, 0, 1};

    private final ServerSocket socket;
    private final GymOrder usual;
    private final ClassLoader classes;
    private final GymStage stage;
    private final Consumer<String> console;

    private GymServer(
            ServerSocket socket, GymOrder usual, ClassLoader classes, GymStage stage, Consumer<String> console) {
        this.socket = socket;
        this.usual = usual;
        this.classes = classes;
        this.stage = stage;
        this.console = console;
    }

    /**
     * Opens the port on 127.0.0.1 and begins to serve, with nothing to watch.
     *
     * @param port the port, 0 for any free one
     * @param usual what programs get that leave something out
     * @param classes where to look for tasks and measures of your own
     * @param console where it tells people what went wrong
     * @return the server
     * @throws IOException if the port is in use
     * @throws IllegalArgumentException if there is no such task or measure; the message says what there is
     */
    public static GymServer open(int port, GymOrder usual, ClassLoader classes, Consumer<String> console)
            throws IOException {
        return open(port, usual, classes, GymStage.NONE, console);
    }

    /**
     * Opens the port on 127.0.0.1 and begins to serve.
     *
     * @param port the port, 0 for any free one
     * @param usual what programs get that leave something out
     * @param classes where to look for tasks and measures of your own
     * @param stage where people can watch
     * @param console where it tells people what went wrong
     * @return the server
     * @throws IOException if the port is in use
     * @throws IllegalArgumentException if there is no such task or measure; the message says what there is
     */
    public static GymServer open(
            int port, GymOrder usual, ClassLoader classes, GymStage stage, Consumer<String> console)
            throws IOException {
        usual.episodes(classes);
        ServerSocket socket = new ServerSocket(port, 50, InetAddress.getByAddress(LOOPBACK));
        GymServer server = new GymServer(socket, usual, classes, stage, console);
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
                            new DataOutputStream(new BufferedOutputStream(client.getOutputStream())),
                            usual,
                            classes,
                            stage)
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
