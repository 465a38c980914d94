package org.robonewbie.studio;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.ServiceLoader;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequests;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.studio.roboviz.RoboVizFeed;

/**
 * Broadcasts the latest state of the simulation to all pages, about 25 times per second.
 *
 * <p>The simulation thread only stores a reference to the state. The feed's thread encodes the state once and sends the
 * bytes to each spectator that has drawn its previous frame; all others skip this frame. A slow page thus delays
 * neither the simulation nor other pages.
 */
final class LiveFeed implements SimulationObserver, TelemetrySink, StudioContext, AutoCloseable {

    /**
     * Minimum interval between frames: slightly less than two cycles, so that every second cycle is sent at real-time
     * speed.
     */
    private static final long SEND_INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(37);

    private static final int MAX_TELEMETRY = 20_000;
    private static final int MAX_MESSAGES = 500;
    private static final long MAX_PARK_NANOS = TimeUnit.MILLISECONDS.toNanos(60);

    /** Maximum time in seconds for which a frozen page can delay closing the studio. */
    private static final int MAX_CLOSE_SECONDS = 1;

    private final SimulationControl simulation;
    private final PuppetService puppets;
    private final RoboVizFeed board = new RoboVizFeed();
    private final TuningRequests numbers = new TuningRequests();
    private final CommandQueue commandQueue = new ThreadedCommandQueue();
    private final UndoManager undoManager = new UndoManager(this, this::messagePrinted);
    private final Queue<MatchEvent> events = new ConcurrentLinkedQueue<>();
    private final Queue<String> sentences = new ConcurrentLinkedQueue<>();
    private final List<Spectator> spectators = new CopyOnWriteArrayList<>();
    private final BlockingQueue<TelemetryMessage> telemetry = new ArrayBlockingQueue<>(MAX_TELEMETRY);
    private final BlockingQueue<AgentMessages> messages = new ArrayBlockingQueue<>(MAX_MESSAGES);
    private final DiagnosticsFeed diagnostics = new DiagnosticsFeed();
    private final TelemetryHistory history = new TelemetryHistory();
    private final Consumer<TelemetryMessage> notes;
    private final Thread sender = new Thread(this::send, "studio-live-feed");
    private volatile @Nullable WorldSnapshot latest;
    private volatile Map<Integer, String> watchedRobots = Map.of();
    private volatile boolean open = true;
    private volatile boolean isTelemetryOutdated;
    private long lastWakeNanos = System.nanoTime() - SEND_INTERVAL_NANOS;

    private @Nullable WorldSnapshot written;
    private @Nullable SceneDescription scene;
    private int sceneRevision;
    private String sceneJson = "";
    private ByteBuffer frame = ByteBuffer.allocate(0);

    /** Creates a feed that does not record telemetry. */
    LiveFeed(SimulationControl simulation) {
        this(simulation, message -> {});
    }

    /** Creates a feed that also passes the robots' telemetry to a recording listener. */
    LiveFeed(SimulationControl simulation, Consumer<TelemetryMessage> notes) {
        this.simulation = simulation;
        this.notes = notes;
        this.puppets = new PuppetService(
                simulation, ServiceLoader.load(PuppetProvider.class).findFirst());
        sender.setDaemon(true);
    }

    void start() {
        simulation.addObserver(this);
        sender.start();
    }

    @Override
    public SimulationControl simulation() {
        return simulation;
    }

    @Override
    public TuningRequests numbers() {
        return numbers;
    }

    @Override
    public Optional<TuningRequests> tuningRequests() {
        return Optional.of(numbers);
    }

    RoboVizFeed board() {
        return board;
    }

    @Override
    public UndoManager undoManager() {
        return undoManager;
    }

    @Override
    public CommandQueue commandQueue() {
        return commandQueue;
    }

    @Override
    public PuppetService puppets() {
        return puppets;
    }

    @Override
    public WorldSnapshot now() {
        WorldSnapshot snapshot = latest;
        if (snapshot == null) {
            throw new IllegalStateException("The simulation has not started yet. Try again in a moment.");
        }
        return snapshot;
    }

    int spectators() {
        return spectators.size();
    }

    void add(Spectator spectator) {
        spectators.add(spectator);
        LockSupport.unpark(sender);
    }

    void remove(Spectator spectator) {
        spectators.remove(spectator);
    }

    /** While no page is open, one snapshot per frame interval suffices for {@link #now}. */
    @Override
    public boolean wantsSnapshot() {
        return isWanted() || latest == null || System.nanoTime() - lastWakeNanos >= SEND_INTERVAL_NANOS;
    }

    @Override
    public void cycleEnded(WorldSnapshot snapshot) {
        latest = snapshot;
        long now = System.nanoTime();
        if (now - lastWakeNanos >= SEND_INTERVAL_NANOS) {
            lastWakeNanos = now;
            LockSupport.unpark(sender);
        }
    }

    @Override
    public boolean wantsMessagesOf(int robot) {
        return watchedRobots.containsKey(robot);
    }

    /** Queues the messages exchanged by a watched robot's agent. Drops them if the queue is full. */
    @Override
    public void messagesExchanged(AgentMessages exchanged) {
        messages.offer(exchanged);
    }

    @Override
    public void happened(MatchEvent event) {
        if (isWanted()) {
            events.add(event);
        }
    }

    @Override
    public void simulationReplaced() {
        undoManager.forget();
    }

    @Override
    public void messagePrinted(String sentence) {
        sentences.add(sentence);
    }

    /** Queues telemetry of a robot. Clears the queue first if it is full. */
    @Override
    public void accept(TelemetryMessage message) {
        if (isWanted() && !telemetry.offer(message)) {
            telemetry.clear();
        }
    }

    /** Discards the log and the errors of programs that have been replaced. Thread-safe. */
    void clearTelemetry() {
        telemetry.clear();
        isTelemetryOutdated = true;
    }

    @Override
    public boolean isWanted() {
        return !spectators.isEmpty();
    }

    private void queueEvents() {
        for (MatchEvent event = events.poll(); event != null; event = events.poll()) {
            String json = SceneDescriptionWriter.event(event);
            spectators.forEach(spectator -> spectator.enqueue(json));
        }
    }

    /** Queues the printed messages. While no page is open, they are kept for the first page that opens. */
    private void queueSentences() {
        while (isWanted() && !sentences.isEmpty()) {
            String json = SceneDescriptionWriter.notice(sentences.remove());
            spectators.forEach(spectator -> spectator.enqueue(json));
        }
    }

    private void queueUndoNames() {
        UndoManager.Names names = undoManager.names();
        spectators.forEach(spectator -> spectator.enqueueUndoNames(names));
    }

    private void queueTelemetry() {
        if (isTelemetryOutdated) {
            isTelemetryOutdated = false;
            history.clear();
            diagnostics.clear();
        }
        List<TelemetryMessage> news = new ArrayList<>();
        telemetry.drainTo(news);
        spectators.forEach(spectator -> spectator.telemetry().remember(history));
        for (TelemetryMessage message : news) {
            history.keep(message);
            notes.accept(message);
            diagnostics.of(message).ifPresent(json -> spectators.forEach(spectator -> spectator.enqueue(json)));
            spectators.forEach(spectator -> spectator.telemetry().add(message));
        }
        queueMessages();
    }

    private void queueMessages() {
        List<AgentMessages> news = new ArrayList<>();
        messages.drainTo(news);
        for (AgentMessages exchanged : news) {
            String robot = watchedRobots.getOrDefault(exchanged.robot(), "");
            spectators.forEach(spectator -> spectator.telemetry().add(robot, exchanged));
        }
    }

    private void updateWatchedRobots(WorldSnapshot snapshot) {
        Map<Integer, String> watched = new HashMap<>();
        for (RobotSnapshot robot : snapshot.robots()) {
            String key = TelemetryHistory.key(robot.team(), robot.number());
            if (spectators.stream().anyMatch(spectator -> spectator.telemetry().watches(key))) {
                watched.put(robot.id(), key);
            }
        }
        watchedRobots = watched;
    }

    private void send() {
        while (open) {
            queueTelemetry();
            queueEvents();
            queueSentences();
            queueUndoNames();
            spectators.forEach(spectator -> spectator.enqueueDrawings(board));
            WorldSnapshot snapshot = latest;
            if (snapshot != null && !spectators.isEmpty()) {
                write(snapshot);
                updateWatchedRobots(snapshot);
                for (Spectator spectator : spectators) {
                    spectator.offer(sceneRevision, sceneJson, frame);
                }
            }
            LockSupport.parkNanos(MAX_PARK_NANOS);
        }
    }

    private void write(WorldSnapshot snapshot) {
        if (snapshot.equals(written)) {
            return;
        }
        puppets.place(snapshot);
        SceneDescription current = SceneDescription.of(simulation, puppets, snapshot);
        if (!current.equals(scene)) {
            scene = current;
            sceneRevision = (sceneRevision + 1) & 0xffff;
            sceneJson = SceneDescriptionWriter.write(current, sceneRevision);
        }
        frame = StateFrame.write(snapshot, sceneRevision);
        written = snapshot;
    }

    @Override
    public void close() {
        simulation.removeObserver(this);
        open = false;
        puppets.close();
        commandQueue.close();
        LockSupport.unpark(sender);
        CompletableFuture.allOf(spectators.stream().map(Spectator::disconnect).toArray(CompletableFuture[]::new))
                .completeOnTimeout(null, MAX_CLOSE_SECONDS, TimeUnit.SECONDS)
                .join();
    }
}
