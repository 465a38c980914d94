package org.robonewbie.programs.process;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;

/**
 * Relay from a TCP port to a Unix domain socket, through which programs in a sandbox without network access reach the
 * simulator.
 */
final class Relay {

    private static final int CHUNK_BYTES = 1 << 16;

    private final ServerSocketChannel port;
    private final Path door;

    private Relay(ServerSocketChannel port, Path door) {
        this.port = port;
        this.door = door;
    }

    /**
     * Opens a port on 127.0.0.1.
     *
     * @param number the port number, 0 for any free one
     * @param door the target of all connections
     * @return the port number
     */
    static int open(int number, Path door) throws IOException {
        ServerSocketChannel port = ServerSocketChannel.open();
        port.bind(new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}), number));
        start(new Relay(port, door)::serve);
        return port.socket().getLocalPort();
    }

    private void serve() {
        try {
            for (SocketChannel program = port.accept(); ; program = port.accept()) {
                connect(program);
            }
        } catch (IOException closed) {
            // No further connections are accepted.
        }
    }

    private void connect(SocketChannel program) throws IOException {
        SocketChannel simulator = SocketChannel.open(StandardProtocolFamily.UNIX);
        try {
            program.setOption(StandardSocketOptions.TCP_NODELAY, true);
            simulator.connect(UnixDomainSocketAddress.of(door));
            start(() -> pump(program, simulator));
            start(() -> pump(simulator, program));
        } catch (IOException gone) {
            program.close();
            simulator.close();
        }
    }

    /** Forwards data in one direction until either connection is closed, then closes both. */
    private static void pump(SocketChannel from, SocketChannel to) {
        try (from;
                to) {
            ByteBuffer chunk = ByteBuffer.allocateDirect(CHUNK_BYTES);
            while (from.read(chunk) >= 0) {
                chunk.flip();
                while (chunk.hasRemaining()) {
                    to.write(chunk);
                }
                chunk.clear();
            }
        } catch (IOException closed) {
            // The try statement closes both ends.
        }
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "relay");
        thread.setDaemon(true);
        thread.start();
    }
}
