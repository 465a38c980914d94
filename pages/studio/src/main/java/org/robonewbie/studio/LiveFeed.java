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
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.telemetry.NumberWishes;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.studio.roboviz.RoboVizFeed;

/**
 * Sends the latest state of the simulation to all pages, about 25 times per second.
 *
 * <p>The simulation's thread only leaves a reference here. A thread of the feed turns it into bytes once and passes them to
 * each spectator that has finished with its last frame; the others miss it. So no page can slow down the simulation or another
 * page.
 */
final class LiveFeed implements SimulationObserver, TelemetrySink, StudioContext, AutoCloseable {

    /** A little less than two cycles, so that in real time every second cycle is sent. */
    private static final long SEND_INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(37);

    private static final int MOST_THOUGHTS = 20_000;
    private static final int MOST_MESSAGES = 500;
    private static final long LATEST_LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(60);

    private final SimulationControl simulation;
    private final PuppetService puppets;
    private final RoboVizFeed board = new RoboVizFeed();
    private final NumberWishes numbers = new NumberWishes();
    private final CommandQueue commandQueue = new ThreadedCommandQueue();
    private final UndoManager undoManager = new UndoManager(this, this::told);
    private final Queue<MatchEvent> events = new ConcurrentLinkedQueue<>();
    private final Queue<String> sentences = new ConcurrentLinkedQueue<>();
    private final List<Spectator> spectators = new CopyOnWriteArrayList<>();
    private final BlockingQueue<TelemetryMessage> telemetry = new ArrayBlockingQueue<>(MOST_THOUGHTS);
    private final BlockingQueue<AgentMessages> messages = new ArrayBlockingQueue<>(MOST_MESSAGES);
    private final DiagnosticsFeed mistakes = new DiagnosticsFeed();
    private final TelemetryHistory memory = new TelemetryHistory();
    private final Consumer<TelemetryMessage> notes;
    private final Thread sender = new Thread(this::send, "studio-live-feed");
    private volatile @Nullable WorldSnapshot latest;
    private volatile Map<Integer, String> watchedRobots = Map.of();
    private volatile boolean open = true;
    private long lastWakeNanos = System.nanoTime() - SEND_INTERVAL_NANOS;

    private @Nullable WorldSnapshot written;
    private @Nullable SceneDescription scene;
    private int sceneRevision;
    private String sceneJson = "";
    private ByteBuffer frame = ByteBuffer.allocate(0);

    /** Feeds pages only. */
    LiveFeed(SimulationControl simulation) {
        this(simulation, message -> {});
    }

    /** Feeds pages, and passes the robots' telemetry on to a listener that records it. */
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
    public NumberWishes numbers() {
        return numbers;
    }

    @Override
    public Optional<NumberWishes> wishes() {
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
            throw new IllegalStateException("The world has not begun yet. Try again in a moment.");
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

    /** Without a page, one snapshot per frame is enough to answer where the world is. */
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

    /** Takes what the agent of a watched robot has said and heard; what is too much for the pages is left out. */
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
    public void anotherBegins() {
        undoManager.forget();
    }

    @Override
    public void told(String sentence) {
        sentences.add(sentence);
    }

    /** Takes what a robot tells; what is too much for the pages is left out. */
    @Override
    public void accept(TelemetryMessage message) {
        if (isWanted() && !telemetry.offer(message)) {
            telemetry.clear();
        }
    }

    @Override
    public boolean isWanted() {
        return !spectators.isEmpty();
    }

    private void handOnEvents() {
        for (MatchEvent event = events.poll(); event != null; event = events.poll()) {
            String json = SceneDescriptionWriter.event(event);
            spectators.forEach(spectator -> spectator.tell(json));
        }
    }

    /** What was told before a page was open is kept for the first one. */
    private void handOnSentences() {
        while (isWanted() && !sentences.isEmpty()) {
            String json = SceneDescriptionWriter.told(sentences.remove());
            spectators.forEach(spectator -> spectator.tell(json));
        }
    }

    private void handOnDeeds() {
        UndoManager.Names names = undoManager.names();
        spectators.forEach(spectator -> spectator.tellDeeds(names));
    }

    private void handOnThoughts() {
        List<TelemetryMessage> news = new ArrayList<>();
        telemetry.drainTo(news);
        spectators.forEach(spectator -> spectator.telemetry().remember(memory));
        for (TelemetryMessage message : news) {
            memory.keep(message);
            notes.accept(message);
            mistakes.of(message).ifPresent(json -> spectators.forEach(spectator -> spectator.tell(json)));
            spectators.forEach(spectator -> spectator.telemetry().hear(message));
        }
        handOnMessages();
    }

    private void handOnMessages() {
        List<AgentMessages> news = new ArrayList<>();
        messages.drainTo(news);
        for (AgentMessages exchanged : news) {
            String robot = watchedRobots.getOrDefault(exchanged.robot(), "");
            spectators.forEach(spectator -> spectator.telemetry().hear(robot, exchanged));
        }
    }

    private void lookWhoIsWatched(WorldSnapshot snapshot) {
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
            handOnThoughts();
            handOnEvents();
            handOnSentences();
            handOnDeeds();
            spectators.forEach(spectator -> spectator.tellDrawings(board));
            WorldSnapshot snapshot = latest;
            if (snapshot != null && !spectators.isEmpty()) {
                write(snapshot);
                lookWhoIsWatched(snapshot);
                for (Spectator spectator : spectators) {
                    spectator.offer(sceneRevision, sceneJson, frame);
                }
            }
            LockSupport.parkNanos(LATEST_LOOK_NANOS);
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
        spectators.forEach(Spectator::sayGoodbye);
    }
}
