package org.robonewbie.studio;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.NumberWishes;
import org.robonewbie.protocol.telemetry.TelemetryMessage;
import org.robonewbie.protocol.telemetry.TelemetrySink;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;

/**
 * Shows a world to one page in whose worker it runs: the messages are those of the live feed, but there is neither thread nor clock
 * nor socket. Used by one thread only.
 */
public final class PageFeed implements TelemetrySink {

    private static final String NOT_HERE =
            "That needs RoboNewbie on your computer: robots steered by hand, and undo, are not in this page yet.";

    private static final OptionalInt NO_PORT = OptionalInt.of(0);

    private final SoccerField field;
    private final Consumer<Order> world;
    private final Page page;
    private final Thoughts thoughts = new Thoughts();
    private final TelemetryHistory memory = new TelemetryHistory();
    private final NumberWishes numbers = new NumberWishes();
    private final MistakeNews mistakes = new MistakeNews();
    private final List<String> news = new ArrayList<>();
    private Optional<TrialLabel> judged = Optional.empty();
    private boolean ready = true;
    private int sceneRevision;
    private @Nullable LineUp scene;
    private @Nullable ByteBuffer shown;

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
    }

    /**
     * Prepares to show a world.
     *
     * @param field its pitch
     * @param world carries out what the page asks for
     * @param page gets the messages
     */
    public PageFeed(SoccerField field, Consumer<Order> world, Page page) {
        this.field = field;
        this.world = world;
        this.page = page;
    }

    /**
     * Says that the world is a trial from now on.
     *
     * @param trial what is judged in it
     */
    public void judge(TrialLabel trial) {
        judged = Optional.of(trial);
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
                thoughts.watch(TelemetryHistory.key(watch.team(), watch.number()));
                thoughts.remember(memory);
            } else if (request instanceof StudioRequest.Tune tune) {
                numbers.put(tune.wish());
            } else if (request instanceof StudioRequest.Orders clock) {
                clock.orders().forEach(world);
            } else if (request instanceof StudioRequest.Change change) {
                change.orders().forEach(world);
            } else {
                news.add(LineUpWriter.told(NOT_HERE));
            }
        } catch (IllegalArgumentException wrong) {
            news.add(LineUpWriter.told(String.valueOf(wrong.getMessage())));
        }
    }

    /**
     * Returns whether the page looks at a robot from inside.
     *
     * @param robot any robot
     * @return whether its agent's messages are wanted
     */
    public boolean watches(RobotSnapshot robot) {
        return thoughts.watches(TelemetryHistory.key(robot.team(), robot.number()));
    }

    /**
     * Keeps what a watched robot's agent says and hears.
     *
     * @param robot the robot
     * @param messages what was said
     */
    public void exchanged(RobotSnapshot robot, AgentMessages messages) {
        thoughts.hear(TelemetryHistory.key(robot.team(), robot.number()), messages);
    }

    /**
     * Keeps what has happened in the game.
     *
     * @param event the event
     */
    public void happened(MatchEvent event) {
        news.add(LineUpWriter.event(event));
    }

    /**
     * Keeps what the simulator tells people.
     *
     * @param sentence a complete sentence
     */
    public void told(String sentence) {
        news.add(LineUpWriter.told(sentence));
    }

    @Override
    public void accept(TelemetryMessage message) {
        memory.keep(message);
        mistakes.of(message).ifPresent(news::add);
        thoughts.hear(message);
    }

    @Override
    public Optional<NumberWishes> wishes() {
        return Optional.of(numbers);
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
        tellWhoPlays(snapshot);
        news.forEach(page::tell);
        news.clear();
        thoughts.take().ifPresent(page::tell);
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
        LineUp current = new LineUp(
                field,
                true,
                NO_PORT,
                false,
                judged,
                snapshot.teamLeft(),
                snapshot.teamRight(),
                snapshot.robots().stream()
                        .map(robot -> LineUp.Player.of(robot, false))
                        .toList(),
                snapshot.things().stream().map(LineUp.Standing::of).toList());
        if (!current.equals(scene)) {
            scene = current;
            sceneRevision++;
            page.tell(LineUpWriter.write(current, sceneRevision));
        }
    }
}
