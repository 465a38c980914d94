package org.robonewbie.simulator.server;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.function.Consumer;
import org.robonewbie.simulator.Console;

/**
 * The TCP port at which agents connect. It belongs to the simulation's thread, which also waits here for whatever comes
 * next; other threads end the waiting with {@link #wakeUp}.
 */
final class AgentPort implements AutoCloseable {

    private static final int ACCEPTED_PER_CYCLE = 64;

    private final ServerSocketChannel channel;
    private final Selector selector;
    private final Console console;

    private AgentPort(ServerSocketChannel channel, Selector selector, Console console) {
        this.channel = channel;
        this.selector = selector;
        this.console = console;
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
        ServerSocketChannel channel = ServerSocketChannel.open();
        try {
            channel.bind(resolve(bindAddress, port), 1024);
            channel.configureBlocking(false);
            Selector selector = Selector.open();
            channel.register(selector, SelectionKey.OP_ACCEPT);
            return new AgentPort(channel, selector, console);
        } catch (IOException e) {
            channel.close();
            throw e instanceof BindException ? inUse(bindAddress, port, e) : e;
        }
    }

    /** {@return the number of the TCP port} */
    int number() {
        return channel.socket().getLocalPort();
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
            channel.close();
            selector.close();
        } catch (IOException e) {
            console.say("The agent port was not closed properly (" + e.getMessage() + ").");
        }
    }

    private void serve(SelectionKey key, Consumer<TcpServerLink> newcomers) {
        if (key.attachment() instanceof TcpServerLink link) {
            link.receive();
        } else {
            accept(newcomers);
        }
    }

    private void accept(Consumer<TcpServerLink> newcomers) {
        try {
            for (int i = 0; i < ACCEPTED_PER_CYCLE; i++) {
                SocketChannel client = channel.accept();
                if (client == null) {
                    return;
                }
                newcomers.accept(link(client));
            }
        } catch (IOException e) {
            console.say("An agent could not be accepted (" + e.getMessage() + ").");
        }
    }

    private TcpServerLink link(SocketChannel client) throws IOException {
        client.configureBlocking(false);
        client.setOption(StandardSocketOptions.TCP_NODELAY, true);
        TcpServerLink link = new TcpServerLink(
                client, String.valueOf(client.getRemoteAddress()).replace("/", ""));
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
