package org.robonewbie.protocol.tcp;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * An agent's connection over TCP to a simulator, either this framework's or rcssserver3d.
 *
 * <pre>{@code
 * try (AgentLink link = TcpAgentLink.connect("127.0.0.1", 3100)) { ... }
 * }</pre>
 */
public final class TcpAgentLink implements AgentLink {

    private static final int CONNECT_MILLISECONDS = 5000;
    private static final int MAX_MESSAGE_BYTES = 1 << 24;

    private final Socket socket;
    private final FrameInput input;
    private final FrameOutput output;

    private TcpAgentLink(Socket socket) throws IOException {
        this.socket = socket;
        socket.setTcpNoDelay(true);
        input = new FrameInput(socket.getInputStream(), MAX_MESSAGE_BYTES);
        output = new FrameOutput(socket.getOutputStream());
    }

    /**
     * Connects to a simulator.
     *
     * @param host host name or address of the simulator
     * @param port agent port, 3100 by default
     * @return the connection
     * @throws IOException if no simulator responds at this address; the message says what to do
     */
    public static TcpAgentLink connect(String host, int port) throws IOException {
        Socket socket = new Socket();
        try {
            socket.connect(new InetSocketAddress(host, port), CONNECT_MILLISECONDS);
            return new TcpAgentLink(socket);
        } catch (UnknownHostException unknown) {
            socket.close();
            throw new IOException("No computer named \"" + host + "\" can be found. Check the host name.", unknown);
        } catch (ConnectException | SocketTimeoutException unreachable) {
            socket.close();
            throw new IOException(
                    "No simulator answers at " + host + ":" + port
                            + ". Start one with \"robonewbie simulator\", or omit the host to start one automatically.",
                    unreachable);
        } catch (IOException broken) {
            socket.close();
            throw broken;
        }
    }

    @Override
    public void send(MessageBuffer message) throws IOException {
        output.write(message);
    }

    @Override
    public boolean receive(MessageBuffer message) throws IOException {
        try {
            return input.read(message);
        } catch (SocketException broken) {
            if (socket.isClosed()) {
                return false;
            }
            throw new IOException(
                    "The connection to the simulator was lost: " + broken.getMessage() + ". Was it stopped?", broken);
        }
    }

    @Override
    public boolean isMessageWaiting() throws IOException {
        return socket.getInputStream().available() > 0;
    }

    @Override
    public void close() {
        try {
            socket.close();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }
}
