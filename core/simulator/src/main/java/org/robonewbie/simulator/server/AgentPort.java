package org.robonewbie.simulator.server;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardProtocolFamily;
import java.net.StandardSocketOptions;
import java.net.UnixDomainSocketAddress;
import java.net.UnknownHostException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.robonewbie.simulator.Console;

/**
 * The TCP port at which agents connect, or a door for each team. It belongs to the simulation's thread, which also waits here for
 * whatever comes next; other threads end the waiting with {@link #wakeUp}.
 */
final class AgentPort implements AutoCloseable {

    private static final String THIS_COMPUTER = "127.0.0.1";
    private static final int BACKLOG = 1024;
    private static final int ACCEPTED_PER_CYCLE = 64;

    private final List<Entrance> entrances = new ArrayList<>();
    private final Selector selector;
    private final Console console;

    private AgentPort(Selector selector, Console console) {
        this.selector = selector;
        this.console = console;
    }

    /** Where agents come in: those of one team, or all. */
    private record Entrance(ServerSocketChannel channel, Optional<TeamDoor> door) {

        /** The TCP port, 0 where it is a file. */
        int number() {
            try {
                return channel.getLocalAddress() instanceof InetSocketAddress internet ? internet.getPort() : 0;
            } catch (IOException closed) {
                return 0;
            }
        }

        boolean belongsTo(String team) {
            return door.filter(own -> own.team().equals(team)).isPresent();
        }

        boolean isOpenTo(SocketAddress guest) {
            return door.isEmpty()
                    || !(guest instanceof InetSocketAddress internet)
                    || door.get().welcome().test(internet);
        }
    }

    /**
     * Opens the port.
     *
     * @param bindAddress address of this computer at which to listen, such as 127.0.0.1
     * @param port the port, or 0 for any free one
     * @param console where to tell problems
     * @return the open port
     * @throws IOException if the port cannot be opened; the message says what to do
     */
    static AgentPort open(String bindAddress, int port, Console console) throws IOException {
        AgentPort opened = new AgentPort(Selector.open(), console);
        try {
            opened.listenAt(resolve(bindAddress, port), new Entrance(ServerSocketChannel.open(), Optional.empty()));
            return opened;
        } catch (IOException e) {
            opened.close();
            throw e instanceof BindException ? inUse(bindAddress, port, e) : e;
        }
    }

    /**
     * Opens a door for each team and no port for others.
     *
     * @param doors the teams
     * @param console where to tell problems
     * @return the open doors
     * @throws IOException if one cannot be opened
     */
    static AgentPort open(List<TeamDoor> doors, Console console) throws IOException {
        AgentPort opened = new AgentPort(Selector.open(), console);
        try {
            for (TeamDoor door : doors) {
                opened.open(door);
            }
            return opened;
        } catch (IOException e) {
            opened.close();
            throw e;
        }
    }

    private void open(TeamDoor door) throws IOException {
        if (door.file().isPresent()) {
            ServerSocketChannel channel = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
            listenAt(UnixDomainSocketAddress.of(door.file().get()), new Entrance(channel, Optional.of(door)));
        } else {
            listenAt(resolve(THIS_COMPUTER, 0), new Entrance(ServerSocketChannel.open(), Optional.of(door)));
        }
    }

    private void listenAt(SocketAddress address, Entrance entrance) throws IOException {
        entrances.add(entrance);
        entrance.channel().bind(address, BACKLOG);
        entrance.channel().configureBlocking(false);
        entrance.channel().register(selector, SelectionKey.OP_ACCEPT, entrance);
    }

    /** {@return the number of the TCP port, 0 if there are only doors of teams} */
    int number() {
        return entrances.stream()
                .filter(entrance -> entrance.door().isEmpty())
                .mapToInt(Entrance::number)
                .findFirst()
                .orElse(0);
    }

    /** The number of a team's own TCP port, 0 if its door is a file or it has none. */
    int number(String team) {
        return entrances.stream()
                .filter(entrance -> entrance.belongsTo(team))
                .mapToInt(Entrance::number)
                .findFirst()
                .orElse(0);
    }

    /**
     * Reads what has arrived on all connections and accepts new ones.
     *
     * @param milliseconds how long to wait for something to happen, 0 not to wait
     * @param newcomers takes the new connections
     * @return whether anything has happened
     */
    boolean listen(long milliseconds, Consumer<TcpServerLink> newcomers) {
        try {
            Consumer<SelectionKey> action = key -> serve(key, newcomers);
            return (milliseconds > 0 ? selector.select(action, milliseconds) : selector.selectNow(action)) > 0;
        } catch (IOException e) {
            console.say("The agent port does not answer (" + e.getMessage() + ").");
            return false;
        }
    }

    /** Ends the waiting of {@link #listen}, from any thread. */
    void wakeUp() {
        selector.wakeup();
    }

    @Override
    public void close() {
        try {
            for (Entrance entrance : entrances) {
                entrance.channel().close();
            }
            selector.close();
        } catch (IOException e) {
            console.say("The agent port was not closed properly (" + e.getMessage() + ").");
        }
    }

    private void serve(SelectionKey key, Consumer<TcpServerLink> newcomers) {
        if (key.attachment() instanceof TcpServerLink link) {
            link.receive();
        } else if (key.attachment() instanceof Entrance entrance) {
            accept(entrance, newcomers);
        }
    }

    private void accept(Entrance entrance, Consumer<TcpServerLink> newcomers) {
        try {
            for (int i = 0; i < ACCEPTED_PER_CYCLE; i++) {
                SocketChannel client = entrance.channel().accept();
                if (client == null) {
                    return;
                }
                if (entrance.isOpenTo(client.getRemoteAddress())) {
                    newcomers.accept(link(client, entrance));
                } else {
                    client.close();
                }
            }
        } catch (IOException e) {
            console.say("An agent could not be accepted (" + e.getMessage() + ").");
        }
    }

    private TcpServerLink link(SocketChannel client, Entrance entrance) throws IOException {
        client.configureBlocking(false);
        boolean remote = client.getRemoteAddress() instanceof InetSocketAddress;
        if (remote) {
            client.setOption(StandardSocketOptions.TCP_NODELAY, true);
        }
        String address = remote
                ? String.valueOf(client.getRemoteAddress()).replace("/", "")
                : entrance.channel().getLocalAddress().toString();
        TcpServerLink link = new TcpServerLink(client, address, entrance.door().map(TeamDoor::team));
        client.register(selector, SelectionKey.OP_READ, link);
        return link;
    }

    private static InetSocketAddress resolve(String bindAddress, int port) throws UnknownHostException {
        InetSocketAddress address = new InetSocketAddress(bindAddress, port);
        if (address.isUnresolved()) {
            throw new UnknownHostException("Address \"" + bindAddress
                    + "\" is unknown. Use 127.0.0.1 for agents on this computer or 0.0.0.0 for all.");
        }
        return address;
    }

    private static IOException inUse(String bindAddress, int port, IOException cause) {
        return new IOException(
                "Port " + port + " on " + bindAddress + " cannot be opened (" + cause.getMessage()
                        + "). Is another simulator running? End it, or choose another port with --agent-port.",
                cause);
    }
}
