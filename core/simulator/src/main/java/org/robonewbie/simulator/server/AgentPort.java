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
 * The selector for the agents' connections. It listens on one TCP port for all agents or on one endpoint per team, and
 * is confined to the simulation thread; other threads may only call {@link #wakeUp}.
 */
final class AgentPort implements AutoCloseable {

    private static final int BACKLOG = 1024;
    private static final int ACCEPTED_PER_CYCLE = 64;

    private final List<Listener> listeners = new ArrayList<>();
    private final Selector selector;
    private final Console console;

    private AgentPort(Selector selector, Console console) {
        this.selector = selector;
        this.console = console;
    }

    /** A listening socket for the agents of one team, or of all teams. */
    private record Listener(ServerSocketChannel channel, Optional<TeamEndpoint> endpoint) {

        /** Returns the TCP port; 0 for a Unix domain socket. */
        int number() {
            try {
                return channel.getLocalAddress() instanceof InetSocketAddress internet ? internet.getPort() : 0;
            } catch (IOException closed) {
                return 0;
            }
        }

        boolean admits(SocketAddress client) {
            return endpoint.isEmpty()
                    || !(client instanceof InetSocketAddress internet)
                    || endpoint.get().admission().test(internet);
        }
    }

    /**
     * Opens one port for all agents, or an endpoint for each team.
     *
     * @throws IOException if a port cannot be opened; the message says what to do
     */
    static AgentPort open(SimulatorSettings.Agents agents, Console console) throws IOException {
        AgentPort opened = new AgentPort(Selector.open(), console);
        try {
            if (agents.endpoints().isEmpty()) {
                opened.listen(resolve(agents.bindAddress(), agents.port()), Optional.empty());
            }
            for (TeamEndpoint endpoint : agents.endpoints()) {
                opened.listen(
                        endpoint.file().isPresent()
                                ? UnixDomainSocketAddress.of(endpoint.file().get())
                                : resolve(SimulatorSettings.LOCALHOST, 0),
                        Optional.of(endpoint));
            }
            return opened;
        } catch (IOException e) {
            opened.close();
            boolean isInUse = e instanceof BindException && agents.endpoints().isEmpty();
            throw isInUse ? inUse(agents.bindAddress(), agents.port(), e) : e;
        }
    }

    private void listen(SocketAddress address, Optional<TeamEndpoint> endpoint) throws IOException {
        ServerSocketChannel channel = address instanceof UnixDomainSocketAddress
                ? ServerSocketChannel.open(StandardProtocolFamily.UNIX)
                : ServerSocketChannel.open();
        Listener listener = new Listener(channel, endpoint);
        listeners.add(listener);
        channel.bind(address, BACKLOG);
        channel.configureBlocking(false);
        channel.register(selector, SelectionKey.OP_ACCEPT, listener);
    }

    /** Returns the TCP port for a team's agents, or for all agents if no team is given; 0 if there is no such port. */
    int number(Optional<String> team) {
        return listeners.stream()
                .filter(listener -> listener.endpoint().map(TeamEndpoint::team).equals(team))
                .mapToInt(Listener::number)
                .findFirst()
                .orElse(0);
    }

    /**
     * Reads from all connections and accepts new ones.
     *
     * @param milliseconds maximum time to wait for activity, 0 to return immediately
     * @param newLinks receives the new connections
     * @return whether there was any activity
     */
    boolean listen(long milliseconds, Consumer<TcpServerLink> newLinks) {
        try {
            Consumer<SelectionKey> action = key -> serve(key, newLinks);
            return (milliseconds > 0 ? selector.select(action, milliseconds) : selector.selectNow(action)) > 0;
        } catch (IOException e) {
            console.say("The agent port cannot be read (" + e.getMessage() + ").");
            return false;
        }
    }

    /** Unblocks a waiting call to {@link #listen}. Thread-safe. */
    void wakeUp() {
        selector.wakeup();
    }

    @Override
    public void close() {
        try {
            for (Listener listener : listeners) {
                listener.channel().close();
            }
            selector.close();
        } catch (IOException e) {
            console.say("The agent port was not closed properly (" + e.getMessage() + ").");
        }
    }

    private void serve(SelectionKey key, Consumer<TcpServerLink> newLinks) {
        if (key.attachment() instanceof TcpServerLink link) {
            link.receive();
        } else if (key.attachment() instanceof Listener listener) {
            accept(listener, newLinks);
        }
    }

    private void accept(Listener listener, Consumer<TcpServerLink> newLinks) {
        try {
            for (int i = 0; i < ACCEPTED_PER_CYCLE; i++) {
                SocketChannel client = listener.channel().accept();
                if (client == null) {
                    return;
                }
                if (listener.admits(client.getRemoteAddress())) {
                    newLinks.accept(link(client, listener));
                } else {
                    client.close();
                }
            }
        } catch (IOException e) {
            console.say("An agent could not be accepted (" + e.getMessage() + ").");
        }
    }

    private TcpServerLink link(SocketChannel client, Listener listener) throws IOException {
        client.configureBlocking(false);
        boolean remote = client.getRemoteAddress() instanceof InetSocketAddress;
        if (remote) {
            client.setOption(StandardSocketOptions.TCP_NODELAY, true);
        }
        String address = remote
                ? String.valueOf(client.getRemoteAddress()).replace("/", "")
                : listener.channel().getLocalAddress().toString();
        TcpServerLink link =
                new TcpServerLink(client, address, listener.endpoint().map(TeamEndpoint::team));
        client.register(selector, SelectionKey.OP_READ, link);
        return link;
    }

    private static InetSocketAddress resolve(String bindAddress, int port) throws UnknownHostException {
        InetSocketAddress address = new InetSocketAddress(bindAddress, port);
        if (address.isUnresolved()) {
            throw new UnknownHostException("Address \"" + bindAddress
                    + "\" is unknown. Use 127.0.0.1 for agents on this computer only or 0.0.0.0 for all interfaces.");
        }
        return address;
    }

    private static IOException inUse(String bindAddress, int port, IOException cause) {
        return new IOException(
                "Port " + port + " on " + bindAddress + " cannot be opened (" + cause.getMessage()
                        + "). Is another simulator running? Stop it, or choose another port with --agent-port.",
                cause);
    }
}
