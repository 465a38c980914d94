package org.robonewbie.studio.roboviz;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;

/**
 * UDP receiver for drawings in the RoboViz protocol, on the loopback interface only.
 *
 * <pre>{@code
 * RoboVizPort port = RoboVizPort.open(RoboVizPort.DEFAULT, studio.drawings());
 * }</pre>
 */
public final class RoboVizPort implements AutoCloseable {

    /** RoboViz's default UDP port. */
    public static final int DEFAULT = 32769;

    private final DatagramSocket socket;
    private final RoboVizFeed board;

    private RoboVizPort(DatagramSocket socket, RoboVizFeed board) {
        this.socket = socket;
        this.board = board;
    }

    /**
     * Starts receiving drawings.
     *
     * @param port UDP port on 127.0.0.1, 0 for any free one
     * @param board receives the drawings
     * @return the open port
     * @throws IOException if the port cannot be opened; the message says what to do
     */
    public static RoboVizPort open(int port, RoboVizFeed board) throws IOException {
        try {
            InetAddress here = InetAddress.getByAddress(new byte[] {127, 0, 0, 1});
            RoboVizPort opened = new RoboVizPort(new DatagramSocket(new InetSocketAddress(here, port)), board);
            Thread listener = new Thread(opened::listen, "roboviz-drawings");
            listener.setDaemon(true);
            listener.start();
            return opened;
        } catch (IOException | IllegalArgumentException e) {
            throw new IOException(
                    "Drawings cannot be received on UDP port " + port
                            + " of 127.0.0.1; RoboViz is probably using it. Stop RoboViz, or choose another port.",
                    e);
        }
    }

    /** {@return the UDP port} */
    public int number() {
        return socket.getLocalPort();
    }

    private void listen() {
        byte[] bytes = new byte[RoboVizReader.MAX_DATAGRAM_BYTES];
        while (!socket.isClosed()) {
            try {
                DatagramPacket datagram = new DatagramPacket(bytes, bytes.length);
                socket.receive(datagram);
                board.execute(RoboVizReader.read(bytes, datagram.getLength()));
            } catch (IOException closedOrBroken) {
                // A closed port ends the loop; a malformed datagram is ignored.
            }
        }
    }

    @Override
    public void close() {
        socket.close();
    }
}
