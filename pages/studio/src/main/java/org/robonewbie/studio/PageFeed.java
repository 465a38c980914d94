package org.robonewbie.studio;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.telemetry.NumberWishes;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.studio.replay.NoteLines;

/**
 * Shows a world to one page in whose worker it runs: the messages are those of the live feed, but there is neither thread nor clock
 * nor socket. Used by one thread only.
 */
public final class PageFeed implements TelemetrySink {

    private final World world;
    private final Page page;
    private final SteppedContext context;
    private final TelemetryFeed telemetry = new TelemetryFeed();
    private final TelemetryHistory memory = new TelemetryHistory();
    private final DiagnosticsFeed mistakes = new DiagnosticsFeed();
    private final NoteLines notes = new NoteLines();
    private final List<String> news = new ArrayList<>();
    private Optional<TrialLabel> judged = Optional.empty();
    private Optional<UndoManager.Names> toldDeeds = Optional.empty();
    private boolean ready = true;
    private int sceneRevision;
    private @Nullable SceneDescription scene;
    private @Nullable ByteBuffer shown;

    /** The world that is shown. What the page asks for is carried out at once, and puppets enter before their maker returns. */
    public interface World extends SimulationControl, PuppetProvider {

        /** {@return its present state} */
        WorldSnapshot now();

        @Override
        default void addObserver(SimulationObserver observer) {
            throw new UnsupportedOperationException("The feed of the page is the only one that looks at its world.");
        }

        @Override
        default void removeObserver(SimulationObserver observer) {
            throw new UnsupportedOperationException("The feed of the page is the only one that looks at its world.");
        }
    }

    /** Where the messages go. */
    public interface Page {

        /**
         * Takes a piece of news.
         *
         * @param json one JSON object
         */
        void tell(String json);

        /**
         * Takes the state of the world.
         *
         * @param frame a state frame
         */
        void show(byte[] frame);

        /**
         * Keeps a note beside the recording of the world.
         *
         * @param note a line of {@link NoteLines}
         */
        void keep(String note);
    }

    /**
     * Prepares to show a world.
     *
     * @param world what is shown and acted upon; it need not have begun
     * @param page gets the messages
     */
    public PageFeed(World world, Page page) {
        this.world = world;
        this.page = page;
        this.context = new SteppedContext(world, this::told);
    }

    /**
     * Says that the world is a trial from now on.
     *
     * @param trial what is judged in it
     */
    public void judge(TrialLabel trial) {
        judged = Optional.of(trial);
    }

    /** What the page can act upon. */
    SteppedContext context() {
        return context;
    }

    /** {@return what is judged in this world; empty where everybody just plays} */
    public Optional<TrialLabel> trial() {
        return judged;
    }

    /**
     * Does what the page asks for.
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
                telemetry.remember(memory);
            } else {
                request.applyTo(context);
            }
        } catch (IllegalArgumentException | IllegalStateException wrong) {
            told(String.valueOf(wrong.getMessage()));
        }
    }

    /**
     * Returns whether the page looks at a robot from inside.
     *
     * @param robot any robot
     * @return whether its agent's messages are wanted
     */
    public boolean watches(RobotSnapshot robot) {
        return telemetry.watches(TelemetryHistory.key(robot.team(), robot.number()));
    }

    /**
     * Keeps what a watched robot's agent says and hears.
     *
     * @param robot the robot
     * @param messages what was said
     */
    public void exchanged(RobotSnapshot robot, AgentMessages messages) {
        telemetry.hear(TelemetryHistory.key(robot.team(), robot.number()), messages);
    }

    /**
     * Keeps what has happened in the game.
     *
     * @param event the event
     */
    public void happened(MatchEvent event) {
        news.add(SceneDescriptionWriter.event(event));
    }

    /**
     * Keeps what the simulator tells people.
     *
     * @param sentence a complete sentence
     */
    public void told(String sentence) {
        news.add(SceneDescriptionWriter.told(sentence));
    }

    @Override
    public void accept(TelemetryMessage message) {
        memory.keep(message);
        mistakes.of(message).ifPresent(news::add);
        telemetry.hear(message);
        notes.of(message).ifPresent(page::keep);
    }

    @Override
    public Optional<NumberWishes> wishes() {
        return Optional.of(context.numbers());
    }

    /** {@return whether the page has drawn what it got last} */
    public boolean isReady() {
        return ready;
    }

    /**
     * Sends the state of the world and all news, if the page is ready for them.
     *
     * @param snapshot the state of the world
     */
    public void show(WorldSnapshot snapshot) {
        if (!ready) {
            return;
        }
        context.puppets().place(snapshot);
        tellWhoPlays(snapshot);
        tellDeeds();
        news.forEach(page::tell);
        news.clear();
        telemetry.take().ifPresent(page::tell);
        ByteBuffer frame = StateFrame.write(snapshot, sceneRevision);
        if (!frame.equals(shown)) {
            ready = false;
            shown = frame;
            byte[] bytes = new byte[frame.remaining()];
            frame.duplicate().get(bytes);
            page.show(bytes);
        }
    }

    private void tellWhoPlays(WorldSnapshot snapshot) {
        SceneDescription current = SceneDescription.of(world, context.puppets(), snapshot);
        if (!current.equals(scene)) {
            scene = current;
            sceneRevision++;
            page.tell(SceneDescriptionWriter.write(current, sceneRevision));
        }
    }

    private void tellDeeds() {
        Optional<UndoManager.Names> names = Optional.of(context.undoManager().names());
        if (!names.equals(toldDeeds)) {
            toldDeeds = names;
            news.add(SceneDescriptionWriter.undoManager(names.get()));
        }
    }
}
