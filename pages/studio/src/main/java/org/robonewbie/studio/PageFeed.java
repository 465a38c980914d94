package org.robonewbie.studio;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.protocol.telemetry.TuningRequests;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.studio.replay.NoteLines;
import org.robonewbie.studio.scene.SceneService;
import org.robonewbie.studio.scene.SceneStore;

/**
 * Live feed for a single page that runs the world in its own worker. It sends the same messages as {@link LiveFeed},
 * but without a thread, a clock or a socket. Not thread-safe.
 */
public final class PageFeed implements TelemetrySink {

    private final World world;
    private final Page page;
    private final SteppedContext context;
    private final TelemetryFeed telemetry = new TelemetryFeed();
    private final TelemetryHistory history = new TelemetryHistory();
    private final DiagnosticsFeed diagnostics = new DiagnosticsFeed();
    private final NoteLines notes = new NoteLines();
    private final List<String> queue = new ArrayList<>();
    private Optional<TrialLabel> judged = Optional.empty();
    private Optional<UndoManager.Names> sentUndoNames = Optional.empty();
    private boolean ready = true;
    private int sceneRevision;
    private @Nullable SceneDescription scene;
    private @Nullable ByteBuffer shown;

    /**
     * The displayed world. It applies commands immediately, and puppets have joined by the time {@link #start} returns.
     */
    public interface World extends SimulationControl, PuppetProvider {

        /** {@return the current state} */
        WorldSnapshot now();

        @Override
        default void addObserver(SimulationObserver observer) {
            throw new UnsupportedOperationException("The simulation in a page does not support observers.");
        }

        @Override
        default void removeObserver(SimulationObserver observer) {
            throw new UnsupportedOperationException("The simulation in a page does not support observers.");
        }
    }

    /** Receiver of the messages. */
    public interface Page {

        /**
         * Receives a message.
         *
         * @param json one JSON object
         */
        void send(String json);

        /**
         * Receives the state of the world.
         *
         * @param frame a state frame
         */
        void show(byte[] frame);

        /**
         * Stores a log entry or drawing alongside the world's recording.
         *
         * @param note one line, as written by {@link NoteLines}
         */
        void keep(String note);
    }

    /**
     * Creates a feed.
     *
     * @param world the displayed world; it need not have started
     * @param page the receiver of the messages
     */
    public PageFeed(World world, Page page) {
        this.world = world;
        this.page = page;
        this.context = new SteppedContext(world, this::messagePrinted);
    }

    /**
     * Labels the world as a trial.
     *
     * @param trial label of the trial
     */
    public void judge(TrialLabel trial) {
        judged = Optional.of(trial);
    }

    SteppedContext context() {
        return context;
    }

    /**
     * Returns the service for scenes of the displayed world.
     *
     * @param store the saved scenes
     * @return the service
     */
    public SceneService scenes(SceneStore store) {
        return new SceneService(store, "this browser", context.undoManager(), context.undoManager()::done);
    }

    /** {@return the trial that runs in this world; empty for free play} */
    public Optional<TrialLabel> trial() {
        return judged;
    }

    /**
     * Executes a command from the page.
     *
     * @param command one JSON object
     */
    public void ask(String command) {
        try {
            StudioRequest request = StudioRequestReader.read(command);
            if (request instanceof StudioRequest.Seen) {
                ready = true;
            } else if (request instanceof StudioRequest.Watch watch) {
                telemetry.watch(TelemetryHistory.key(watch.team(), watch.number()));
                telemetry.remember(history);
            } else {
                request.applyTo(context);
            }
        } catch (IllegalArgumentException | IllegalStateException wrong) {
            messagePrinted(String.valueOf(wrong.getMessage()));
        }
    }

    /**
     * Returns whether a robot's internals are displayed on the page.
     *
     * @param robot a robot
     * @return whether its agent's messages are needed
     */
    public boolean watches(RobotSnapshot robot) {
        return telemetry.watches(TelemetryHistory.key(robot.team(), robot.number()));
    }

    /**
     * Queues the messages exchanged by a watched robot's agent.
     *
     * @param robot the robot
     * @param messages the messages of one cycle
     */
    public void exchanged(RobotSnapshot robot, AgentMessages messages) {
        telemetry.add(TelemetryHistory.key(robot.team(), robot.number()), messages);
    }

    /**
     * Queues a match event.
     *
     * @param event the event
     */
    public void happened(MatchEvent event) {
        queue.add(SceneDescriptionWriter.event(event));
    }

    /**
     * Queues a message from the simulator to the user.
     *
     * @param sentence a complete sentence
     */
    public void messagePrinted(String sentence) {
        queue.add(SceneDescriptionWriter.notice(sentence));
    }

    @Override
    public void accept(TelemetryMessage message) {
        history.keep(message);
        diagnostics.of(message).ifPresent(queue::add);
        telemetry.add(message);
        notes.of(message).ifPresent(page::keep);
    }

    /** Discards the log and the errors of programs that have been replaced. */
    public void clearTelemetry() {
        history.clear();
        diagnostics.clear();
    }

    @Override
    public Optional<TuningRequests> tuningRequests() {
        return Optional.of(context.numbers());
    }

    /** {@return whether the page has drawn the last frame} */
    public boolean isReady() {
        return ready;
    }

    /**
     * Sends the state of the world and all queued messages if the page is ready.
     *
     * @param snapshot the state of the world
     */
    public void show(WorldSnapshot snapshot) {
        if (!ready) {
            return;
        }
        context.puppets().place(snapshot);
        sendScene(snapshot);
        queueUndoNames();
        queue.forEach(page::send);
        queue.clear();
        telemetry.take().ifPresent(page::send);
        ByteBuffer frame = StateFrame.write(snapshot, sceneRevision);
        if (!frame.equals(shown)) {
            ready = false;
            shown = frame;
            byte[] bytes = new byte[frame.remaining()];
            frame.duplicate().get(bytes);
            page.show(bytes);
        }
    }

    private void sendScene(WorldSnapshot snapshot) {
        SceneDescription current = SceneDescription.of(world, context.puppets(), snapshot);
        if (!current.equals(scene)) {
            scene = current;
            sceneRevision++;
            page.send(SceneDescriptionWriter.write(current, sceneRevision));
        }
    }

    private void queueUndoNames() {
        Optional<UndoManager.Names> names = Optional.of(context.undoManager().names());
        if (!names.equals(sentUndoNames)) {
            sentUndoNames = names;
            queue.add(SceneDescriptionWriter.undoManager(names.get()));
        }
    }
}
