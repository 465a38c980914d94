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
 * The TCP port at which monitors such as RoboViz watch the world and trainers change it.
 *
 * <p>All work is done in a background thread: the simulation only hands over snapshots, and only while a monitor is connected.
 * Slow monitors lose messages; they never hold up the world or each other.
 *
 * <pre>{@code
 * MonitorPort monitors = MonitorPort.open(settings, console, trainerCommands::add);
 * monitors.cycleEnded(cycle, () -> snapshot);                  // after each cycle
 * }</pre>
 */
public final class MonitorPort implements AutoCloseable {

    private static final int WAITING_SNAPSHOTS = 64;
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
    private final BlockingQueue<Shown> waiting = new ArrayBlockingQueue<>(WAITING_SNAPSHOTS);
    private final List<MonitorConnection> connections = new ArrayList<>();
    private final Set<String> warnings = new HashSet<>();
    private final Thread thread = new Thread(this::run, "monitor-port");
    private volatile int monitors;
    private volatile boolean closed;
    private boolean fullWanted;

    private record Shown(MonitorSnapshot snapshot, boolean fullWanted) {}

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
        broadcast = new MonitorBroadcast(settings.environment(), settings.field(), settings.ballRadius());
    }

    /**
     * Opens the port.
     *
     * @param settings where to listen and what to tell
     * @param console takes sentences for people
     * @param trainer takes the commands of monitors, on the port's thread; must not wait
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

    /** {@return the number of the TCP port} */
    public int number() {
        return channel.socket().getLocalPort();
    }

    /** {@return the number of connected monitors} */
    public int monitors() {
        return monitors;
    }

    /** Waits until as many monitors are connected. */
    synchronized void awaitMonitors(int count) throws InterruptedException {
        while (monitors != count) {
            wait();
        }
    }

    /**
     * Sends a cycle to the monitors if one is due and a monitor is connected; returns at once. Must be called on the
     * simulation's thread.
     *
     * @param cycle number of the cycle
     * @param snapshot makes the snapshot, if needed
     */
    public void cycleEnded(long cycle, Supplier<MonitorSnapshot> snapshot) {
        if (monitors > 0 && cycle % settings.cyclesPerMessage() == 0) {
            show(snapshot.get());
        }
    }

    /**
     * Sends a state out of turn, for example while the clock is stopped. Must be called on the simulation's thread.
     *
     * @param snapshot the state
     */
    public void show(MonitorSnapshot snapshot) {
        if (monitors > 0 && waiting.offer(new Shown(snapshot, fullWanted))) {
            fullWanted = false;
            selector.wakeup();
        }
    }

    /** Makes the next message a full one for all monitors. Must be called on the simulation's thread. */
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
                showWaiting();
                connections.removeIf(connection -> !connection.isOpen());
                count();
            }
        } catch (IOException | RuntimeException e) {
            console.accept("The monitor port has stopped working (" + e + "); the simulation goes on.");
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
                warn("A monitor was disconnected since its message could not be handled (" + unexpected
                        + "); please report this.");
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
                welcome(client);
            }
        } catch (IOException e) {
            warn("A monitor could not be accepted (" + e.getMessage() + ").");
            LockSupport.parkNanos(PAUSE_AFTER_FAILURE_NANOSECONDS);
        }
    }

    private void welcome(SocketChannel client) throws IOException {
        if (connections.size() >= MAX_MONITORS) {
            warn("A monitor was refused because " + MAX_MONITORS + " are connected already.");
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

    /** Reports each kind of problem once, however often it occurs. */
    private void warn(String sentence) {
        if (warnings.size() < MAX_WARNINGS && warnings.add(sentence)) {
            console.accept(sentence);
        }
    }

    private void showWaiting() {
        for (Shown shown = waiting.poll(); shown != null; shown = waiting.poll()) {
            broadcast.send(shown.snapshot(), shown.fullWanted(), connections);
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
                    + "\" is unknown. Use 127.0.0.1 for monitors on this computer or 0.0.0.0 for all.");
        }
        return address;
    }

    private static IOException inUse(MonitorSettings settings, IOException cause) {
        return new IOException(
                "Monitor port " + settings.port() + " on " + settings.bindAddress() + " cannot be opened ("
                        + cause.getMessage()
                        + "). Is another simulator running? End it, or choose another port with --monitor-port.",
                cause);
    }
}
