package org.robonewbie.simulator.monitor;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.net.UnknownHostException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robonewbie.protocol.order.Order;

/**
 * The TCP port for monitors such as RoboViz and for trainers.
 *
 * <p>A background thread serves the connections. The simulation thread only queues snapshots, and only while a monitor is
 * connected. Slow monitors miss messages; they never block the simulation or other monitors.
 *
 * <pre>{@code
 * MonitorPort monitors = MonitorPort.open(settings, console, trainerCommands::add);
 * monitors.cycleEnded(cycle, () -> snapshot);                  // after each cycle
 * }</pre>
 */
public final class MonitorPort implements AutoCloseable {

    private static final int MAX_QUEUED_SNAPSHOTS = 64;
    private static final int MAX_MONITORS = 500;
    private static final int BACKLOG = 1024;
    private static final int MAX_WARNINGS = 20;
    private static final long PAUSE_AFTER_FAILURE_NANOSECONDS = 50_000_000;

    private final MonitorSettings settings;
    private final Consumer<String> console;
    private final Consumer<Order> trainer;
    private final ServerSocketChannel channel;
    private final Selector selector;
    private final MonitorBroadcast broadcast;
    private final BlockingQueue<Update> updates = new ArrayBlockingQueue<>(MAX_QUEUED_SNAPSHOTS);
    private final List<MonitorConnection> connections = new ArrayList<>();
    private final Set<String> warnings = new HashSet<>();
    private final Thread thread = new Thread(this::run, "monitor-port");
    private volatile int monitors;
    private volatile boolean closed;
    private boolean fullWanted;

    private record Update(MonitorSnapshot snapshot, boolean fullWanted) {}

    private MonitorPort(
            MonitorSettings settings,
            Consumer<String> console,
            Consumer<Order> trainer,
            ServerSocketChannel channel,
            Selector selector) {
        this.settings = settings;
        this.console = console;
        this.trainer = trainer;
        this.channel = channel;
        this.selector = selector;
        broadcast = new MonitorBroadcast(settings.parameters());
    }

    /**
     * Opens the port.
     *
     * @param settings the configuration
     * @param console output for messages to the user
     * @param trainer receives commands from monitors, on the port's thread; must not block
     * @return the open port
     * @throws IOException if the port cannot be opened; the message says what to do
     */
    public static MonitorPort open(MonitorSettings settings, Consumer<String> console, Consumer<Order> trainer)
            throws IOException {
        ServerSocketChannel channel = ServerSocketChannel.open();
        try {
            channel.bind(address(settings), BACKLOG);
            channel.configureBlocking(false);
            Selector selector = Selector.open();
            channel.register(selector, SelectionKey.OP_ACCEPT);
            MonitorPort port = new MonitorPort(settings, console, trainer, channel, selector);
            port.thread.setDaemon(true);
            port.thread.start();
            return port;
        } catch (IOException e) {
            channel.close();
            throw e instanceof BindException ? inUse(settings, e) : e;
        }
    }

    /** {@return the TCP port} */
    public int number() {
        return channel.socket().getLocalPort();
    }

    /** {@return the number of connected monitors} */
    public int monitors() {
        return monitors;
    }

    /** Waits until {@code count} monitors are connected. */
    synchronized void awaitMonitors(int count) throws InterruptedException {
        while (monitors != count) {
            wait();
        }
    }

    /**
     * Sends the state after a cycle if a message is due and a monitor is connected. Non-blocking; call only on the simulation
     * thread.
     *
     * @param cycle number of the cycle
     * @param snapshot supplies the snapshot if needed
     */
    public void cycleEnded(long cycle, Supplier<MonitorSnapshot> snapshot) {
        if (monitors > 0 && cycle % settings.cyclesPerMessage() == 0) {
            show(snapshot.get());
        }
    }

    /**
     * Sends a state immediately, for example while the clock is paused. Call only on the simulation thread.
     *
     * @param snapshot the state
     */
    public void show(MonitorSnapshot snapshot) {
        if (monitors > 0 && updates.offer(new Update(snapshot, fullWanted))) {
            fullWanted = false;
            selector.wakeup();
        }
    }

    /** Makes the next message to every monitor a full message. Call only on the simulation thread. */
    public void requestFullState() {
        fullWanted = true;
    }

    /** Closes the port and all connections. */
    @Override
    public void close() {
        closed = true;
        selector.wakeup();
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void run() {
        try {
            while (!closed) {
                selector.select(this::serve);
                sendUpdates();
                connections.removeIf(connection -> !connection.isOpen());
                count();
            }
        } catch (IOException | RuntimeException e) {
            console.accept("The monitor port has failed (" + e + "). The simulation continues.");
        } finally {
            closeAll();
        }
    }

    private void serve(SelectionKey key) {
        if (!key.isValid()) {
            return;
        }
        if (key.attachment() instanceof MonitorConnection connection) {
            try {
                serve(key, connection);
            } catch (RuntimeException unexpected) {
                warn("A monitor was disconnected because its message caused an internal error (" + unexpected
                        + "). Please report this.");
                connection.close();
            }
        } else {
            accept();
        }
    }

    private void serve(SelectionKey key, MonitorConnection connection) {
        if (key.isWritable()) {
            connection.flush();
        }
        if (key.isValid() && key.isReadable()) {
            connection.receive().forEach(trainer);
        }
    }

    private void accept() {
        try {
            for (SocketChannel client = channel.accept(); client != null; client = channel.accept()) {
                admit(client);
            }
        } catch (IOException e) {
            warn("A monitor could not be accepted (" + e.getMessage() + ").");
            LockSupport.parkNanos(PAUSE_AFTER_FAILURE_NANOSECONDS);
        }
    }

    private void admit(SocketChannel client) throws IOException {
        if (connections.size() >= MAX_MONITORS) {
            warn("A monitor was refused because " + MAX_MONITORS + " are already connected.");
            client.close();
            return;
        }
        try {
            client.configureBlocking(false);
            client.setOption(StandardSocketOptions.TCP_NODELAY, true);
            add(client);
        } catch (IOException gone) {
            client.close();
        }
    }

    private void add(SocketChannel client) throws IOException {
        SelectionKey key = client.register(selector, SelectionKey.OP_READ);
        MonitorConnection connection = new MonitorConnection(client, key, this::warn);
        key.attach(connection);
        connections.add(connection);
        count();
    }

    private synchronized void count() {
        monitors = connections.size();
        notifyAll();
    }

    /** Reports a problem unless the same one has been reported before. */
    private void warn(String sentence) {
        if (warnings.size() < MAX_WARNINGS && warnings.add(sentence)) {
            console.accept(sentence);
        }
    }

    private void sendUpdates() {
        for (Update update = updates.poll(); update != null; update = updates.poll()) {
            broadcast.send(update.snapshot(), update.fullWanted(), connections);
        }
    }

    private void closeAll() {
        monitors = 0;
        connections.forEach(MonitorConnection::close);
        try {
            channel.close();
            selector.close();
        } catch (IOException e) {
            console.accept("The monitor port was not closed properly (" + e.getMessage() + ").");
        }
    }

    private static InetSocketAddress address(MonitorSettings settings) throws UnknownHostException {
        InetSocketAddress address = new InetSocketAddress(settings.bindAddress(), settings.port());
        if (address.isUnresolved()) {
            throw new UnknownHostException("Address \"" + settings.bindAddress()
                    + "\" is unknown. Use 127.0.0.1 for monitors on this computer only or 0.0.0.0 for all interfaces.");
        }
        return address;
    }

    private static IOException inUse(MonitorSettings settings, IOException cause) {
        return new IOException(
                "Monitor port " + settings.port() + " on " + settings.bindAddress() + " cannot be opened ("
                        + cause.getMessage()
                        + "). Is another simulator running? Stop it, or choose another port with --monitor-port.",
                cause);
    }
}
