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
 * Admits agents of other processes to a trial: a port of this computer that speaks to them as a simulator does, so any agent
 * can join, whatever its language.
 *
 * <pre>{@code
 * try (GuestDoor door = GuestDoor.open(0, 10)) {
 *     Trial trial = Trial.served(scene, 1, door.await(() -> true));
 * }
 * }</pre>
 */
public final class GuestDoor implements AutoCloseable {

    private static final int LOOK_MILLISECONDS = 100;

    private final ServerSocketChannel channel;
    private final Selector selector;
    private final double patienceSeconds;
    private final Predicate<InetSocketAddress> welcome;

    private GuestDoor(
            ServerSocketChannel channel,
            Selector selector,
            double patienceSeconds,
            Predicate<InetSocketAddress> welcome) {
        this.channel = channel;
        this.selector = selector;
        this.patienceSeconds = patienceSeconds;
        this.welcome = welcome;
    }

    /**
     * Opens the door on 127.0.0.1.
     *
     * @param port its TCP port, 0 for any free one
     * @param patienceSeconds how long an agent may think about one message; 0 for as long as it likes, for debuggers
     * @return the open door
     * @throws IOException if the port is in use
     */
    public static GuestDoor open(int port, double patienceSeconds) throws IOException {
        InetAddress here = InetAddress.getByAddress(new byte[] {127, 0, 0, 1});
        return open(new InetSocketAddress(here, port), patienceSeconds, guest -> true);
    }

    /**
     * Opens a door that not everybody may use.
     *
     * @param address a TCP port, or the file of a Unix domain socket, which is made
     * @param patienceSeconds how long an agent at a TCP port may think about one message; 0 for as long as it likes
     * @param welcome decides, from the other end's address, who may come in through a TCP port
     * @return the open door
     * @throws IOException if the port is in use
     */
    public static GuestDoor open(SocketAddress address, double patienceSeconds, Predicate<InetSocketAddress> welcome)
            throws IOException {
        boolean file = address instanceof UnixDomainSocketAddress;
        ServerSocketChannel channel =
                file ? ServerSocketChannel.open(StandardProtocolFamily.UNIX) : ServerSocketChannel.open();
        try {
            channel.bind(address);
            channel.configureBlocking(false);
            Selector selector = Selector.open();
            channel.register(selector, SelectionKey.OP_ACCEPT);
            return new GuestDoor(channel, selector, patienceSeconds, welcome);
        } catch (IOException inUse) {
            channel.close();
            throw inUse;
        }
    }

    /** {@return the TCP port for agents; 0 for a door that is a file} */
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
     * @param expected asked again and again whether an agent may still come
     * @return the agent
     * @throws AbsentProgramException if it does not come any more
     */
    public Controller await(BooleanSupplier expected) {
        Optional<Controller> guest = Optional.empty();
        while (guest.isEmpty() && expected.getAsBoolean() && channel.isOpen()) {
            guest = look();
        }
        return guest.orElseThrow(() -> new AbsentProgramException("The program ended before it asked for a robot."));
    }

    /** Waits a moment for an agent. */
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
            return Optional.of(GuestController.welcome(guest, patienceSeconds));
        } catch (ClosedSelectorException | ClosedChannelException closed) {
            return Optional.empty();
        } catch (IOException broken) {
            throw new AbsentProgramException("The connection of the program broke before it had a robot.", broken);
        }
    }

    /** Admits no more agents; those inside may stay. */
    @Override
    public void close() {
        try {
            channel.close();
            selector.close();
        } catch (IOException broken) {
            throw new AbsentProgramException("The door for agents cannot be closed.", broken);
        }
    }
}
