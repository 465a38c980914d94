package org.robonewbie.programs.process;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.robonewbie.trial.Controller;

/**
 * Port through which agents in other processes join a trial. It uses the simulator's protocol, so that agents in any
 * language can join.
 *
 * <pre>{@code
 * try (GuestDoor door = GuestDoor.open(0)) {
 *     Trial trial = Trial.served(scene, 1, door.await(() -> true));
 * }
 * }</pre>
 */
public final class GuestDoor implements AutoCloseable {

    private static final int LOOK_MILLISECONDS = 100;

    private final ServerSocketChannel channel;
    private final Selector selector;
    private final Predicate<InetSocketAddress> welcome;

    private GuestDoor(ServerSocketChannel channel, Selector selector, Predicate<InetSocketAddress> welcome) {
        this.channel = channel;
        this.selector = selector;
        this.welcome = welcome;
    }

    /**
     * Opens a TCP port on 127.0.0.1.
     *
     * @param port the TCP port, 0 for any free one
     * @return the open port
     * @throws IOException if the port is in use
     */
    public static GuestDoor open(int port) throws IOException {
        InetAddress here = InetAddress.getByAddress(new byte[] {127, 0, 0, 1});
        return open(new InetSocketAddress(here, port), guest -> true);
    }

    /**
     * Opens a port with access control.
     *
     * @param address a TCP port, or the file of a Unix domain socket, which is created
     * @param welcome decides whether a client that connects over TCP is accepted, based on its address
     * @return the open port
     * @throws IOException if the port is in use
     */
    public static GuestDoor open(SocketAddress address, Predicate<InetSocketAddress> welcome) throws IOException {
        boolean file = address instanceof UnixDomainSocketAddress;
        ServerSocketChannel channel =
                file ? ServerSocketChannel.open(StandardProtocolFamily.UNIX) : ServerSocketChannel.open();
        try {
            channel.bind(address);
            channel.configureBlocking(false);
            Selector selector = Selector.open();
            channel.register(selector, SelectionKey.OP_ACCEPT);
            return new GuestDoor(channel, selector, welcome);
        } catch (IOException inUse) {
            channel.close();
            throw inUse;
        }
    }

    /** {@return the TCP port for agents; 0 for a Unix domain socket} */
    public int port() {
        try {
            return channel.getLocalAddress() instanceof InetSocketAddress internet ? internet.getPort() : 0;
        } catch (IOException closed) {
            return 0;
        }
    }

    /**
     * Waits for the next agent.
     *
     * @param expected whether an agent may still join; polled while waiting
     * @return the agent
     * @throws AbsentProgramException if no agent is expected any longer
     */
    public Controller await(BooleanSupplier expected) {
        Optional<Controller> guest = Optional.empty();
        while (guest.isEmpty() && expected.getAsBoolean() && channel.isOpen()) {
            guest = look();
        }
        return guest.orElseThrow(() -> new AbsentProgramException("The program ended before it asked for a robot."));
    }

    /** Waits briefly for an agent. */
    private Optional<Controller> look() {
        try {
            selector.select(LOOK_MILLISECONDS);
            selector.selectedKeys().clear();
            SocketChannel guest = channel.accept();
            if (guest == null) {
                return Optional.empty();
            }
            if (guest.getRemoteAddress() instanceof InetSocketAddress internet && !welcome.test(internet)) {
                guest.close();
                return Optional.empty();
            }
            return Optional.of(GuestController.welcome(guest));
        } catch (ClosedSelectorException | ClosedChannelException closed) {
            return Optional.empty();
        } catch (IOException broken) {
            throw new AbsentProgramException("The program lost its connection before it had a robot.", broken);
        }
    }

    /** Closes the port. Agents that have joined stay connected. */
    @Override
    public void close() {
        try {
            channel.close();
            selector.close();
        } catch (IOException broken) {
            throw new AbsentProgramException("The agent port cannot be closed.", broken);
        }
    }
}
