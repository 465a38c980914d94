package org.robonewbie.protocol.tcp;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.MonitoredWorld;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.TrainerOrderWriter;

/**
 * A connection to the monitor port of a SimSpark server, either this framework's simulator or rcssserver3d. It receives the state of
 * the world and sends trainer commands.
 *
 * <pre>{@code
 * try (MonitorLink monitor = MonitorLink.connect("127.0.0.1", 3200)) {
 *     monitor.send(new Order.KickOff(Optional.of(TeamSide.LEFT)));
 *     while (monitor.receive()) {
 *         System.out.println(monitor.world().gameState());
 *     }
 * }
 * }</pre>
 */
public final class MonitorLink implements AutoCloseable {

    private final AgentLink link;
    private final MessageBuffer incoming = new MessageBuffer();
    private final MessageBuffer outgoing = new MessageBuffer();
    private final TrainerOrderWriter writer = new TrainerOrderWriter(outgoing);
    private final MonitoredWorld world = new MonitoredWorld();

    private MonitorLink(AgentLink link) {
        this.link = link;
    }

    /**
     * Connects to a server.
     *
     * @param host host name or address of the server
     * @param port monitor port, 3200 by default
     * @return the connection
     * @throws IOException if no server responds at this address; the message says what to do
     */
    public static MonitorLink connect(String host, int port) throws IOException {
        return new MonitorLink(TcpAgentLink.connect(host, port));
    }

    /**
     * Waits for the next message and applies it to the {@link #world}.
     *
     * @return false if the server has closed the connection
     * @throws IOException if the connection is broken
     */
    public boolean receive() throws IOException {
        boolean received = link.receive(incoming);
        if (received) {
            world.read(incoming);
        }
        return received;
    }

    /** {@return the world as of the last message; always the same object} */
    public MonitoredWorld world() {
        return world;
    }

    /** {@return the last message as received, valid until the next one} */
    public MessageBuffer lastMessage() {
        return incoming;
    }

    /**
     * Sends trainer commands in one message.
     *
     * @param orders the commands, in the order of execution
     * @throws IOException if the connection is broken
     */
    public void send(Order.Trainer... orders) throws IOException {
        outgoing.clear();
        for (Order.Trainer order : orders) {
            writer.write(order);
        }
        link.send(outgoing);
    }

    /** Closes the connection. */
    @Override
    public void close() {
        link.close();
    }
}
