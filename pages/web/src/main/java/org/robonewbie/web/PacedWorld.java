package org.robonewbie.web;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.PageFeed;

/** The displayed world and its clock. The page's worker advances the world a little at regular intervals. */
final class PacedWorld implements PageFeed.World {

    private static final long MAX_TURN_NANOS = 15_000_000;
    private static final double MAX_LAG_SECONDS = 0.2;
    private static final double SMOOTHING_SECONDS = 1;
    private static final OptionalInt NO_PORT = OptionalInt.of(0);

    private final PageFeed feed;
    private SteppedWorld world;
    private boolean paused;
    private int stepsLeft;
    private double speed = 1;
    private double realTimeFactor = 1;
    private double owedSeconds;

    /**
     * Creates and shows a world.
     *
     * @param page receives the messages
     * @param maker creates the world, which reports events to the given feed
     */
    PacedWorld(PageFeed.Page page, Function<PageFeed, ? extends SteppedWorld> maker) {
        feed = new PageFeed(this, page);
        world = maker.apply(feed);
    }

    PageFeed feed() {
        return feed;
    }

    /**
     * Shows another world at the same speed.
     *
     * @param next the world
     */
    void show(SteppedWorld next) {
        world = next;
        owedSeconds = 0;
    }

    /** Executes a command from the page. */
    void ask(String command) {
        feed.ask(command);
    }

    /**
     * Advances the world as far as the chosen speed and the processor allow, and updates the page.
     *
     * @param seconds time since the last call
     */
    void turn(double seconds) {
        long begin = System.nanoTime();
        long before = world.cycles();
        owedSeconds = Math.min(owedSeconds, MAX_LAG_SECONDS) + seconds * speed;
        List<RobotSnapshot> watched =
                now().robots().stream().filter(feed::watches).toList();
        while (isCycleDue() && System.nanoTime() - begin < MAX_TURN_NANOS) {
            cycle(watched);
        }
        double weight = Math.min(1, seconds / SMOOTHING_SECONDS);
        double factor = (world.cycles() - before) * Cycle.SECONDS / Math.max(seconds, 1e-3);
        realTimeFactor += weight * (factor - realTimeFactor);
        if (feed.isReady()) {
            feed.show(now());
        }
    }

    private boolean isCycleDue() {
        return !world.isOver() && (stepsLeft > 0 || (!paused && owedSeconds >= Cycle.SECONDS));
    }

    private void cycle(List<RobotSnapshot> watched) {
        stepsLeft = Math.max(0, stepsLeft - 1);
        owedSeconds -= Cycle.SECONDS;
        world.cycle();
        for (RobotSnapshot robot : watched) {
            world.messages(id -> id == robot.id()).forEach(messages -> feed.exchanged(robot, messages));
        }
    }

    @Override
    public WorldSnapshot now() {
        boolean stands = paused || world.isOver();
        return world.snapshot(stands, speed).withPace(stands, speed, realTimeFactor);
    }

    @Override
    public SoccerField field() {
        return SoccerField.BEGINNER;
    }

    @Override
    public Optional<TrialLabel> trial() {
        return feed.trial();
    }

    @Override
    public OptionalInt agentPort() {
        return NO_PORT;
    }

    @Override
    public void order(Order order) {
        if (order instanceof Order.Pause) {
            hold(0);
        } else if (order instanceof Order.Resume) {
            paused = false;
            owedSeconds = 0;
        } else if (order instanceof Order.Step step) {
            hold(stepsLeft + step.cycles());
        } else if (order instanceof Order.SetSpeed wanted) {
            speed = wanted.factor();
            owedSeconds = 0;
        } else {
            world.order(order);
        }
    }

    private void hold(int cycles) {
        paused = true;
        stepsLeft = cycles;
        owedSeconds = 0;
    }

    @Override
    public void save(Consumer<Optional<WorldState>> receiver) {
        receiver.accept(open().flatMap(EditableWorld::save));
    }

    @Override
    public void restore(WorldState state, Consumer<OptionalInt> receiver) {
        receiver.accept(open().map(free -> free.restore(state)).orElse(OptionalInt.empty()));
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        open().ifPresent(free -> free.restore(before, moment));
    }

    @Override
    public Optional<AgentLink> connect() {
        return open().map(EditableWorld::connect);
    }

    @Override
    public Puppet start(AgentLink link, String team, int number, int type) {
        return open().orElseThrow().start(link, team, number, type);
    }

    private Optional<EditableWorld> open() {
        return world instanceof EditableWorld free ? Optional.of(free) : Optional.empty();
    }
}
