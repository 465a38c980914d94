package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.function.Function;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.nao.Cycle;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.studio.PageFeed;
import org.robonewbie.web.bytecode.Program;

/** The beginners' world with one agent, which a page watches; it goes on a little in each turn of the page's worker. */
final class LiveWorld {

    private static final long LONGEST_TURN_NANOS = 15_000_000;
    private static final double MOST_BEHIND_SECONDS = 0.2;
    private static final double SMOOTHING_SECONDS = 1;

    private final SteppedSimulator simulator;
    private final Runnable player;
    private final PageFeed feed;
    private boolean paused;
    private int stepsLeft;
    private double speed = 1;
    private double realTimeFactor = 1;
    private double owedSeconds;

    /**
     * Lets an agent enter a new world.
     *
     * @param name one of {@link ShippedAgents}
     * @param seed start of all random numbers
     * @param page gets what happens
     */
    LiveWorld(String name, long seed, PageFeed.Page page) {
        this(seed, page, world -> world.agent(ShippedAgents.make(name)));
    }

    /**
     * Lets a program of a student enter a new world.
     *
     * @param program its classes
     * @param run gets how it goes
     * @param seed start of all random numbers
     * @param page gets what happens
     */
    LiveWorld(Program program, StudentRun run, long seed, PageFeed.Page page) {
        this(seed, page, world -> run.begin(world.student(program, run)));
    }

    private LiveWorld(long seed, PageFeed.Page page, Function<LiveWorld, Runnable> entrance) {
        WorldSettings settings = WorldSettings.beginner().withSeed(seed);
        feed = new PageFeed(settings.parameters().field(), this::order, page);
        simulator = SteppedSimulator.start(settings, feed::told);
        simulator.reportEventsTo(feed::happened);
        player = entrance.apply(this);
        player.run();
    }

    private Runnable agent(Agent made) {
        AgentDriver agent = new AgentDriver(made);
        agent.publishTo(feed);
        PatientLink link = new PatientLink(simulator.connect());
        try {
            agent.join(link, agent.usualOptions().withSeconds(StudentProgram.FOREVER_SECONDS));
        } catch (IOException impossible) {
            throw new UncheckedIOException("The world of the page has closed its connection.", impossible);
        }
        link.beBusy();
        return agent::goOn;
    }

    private StudentProgram student(Program program, StudentRun run) {
        return new StudentProgram(program, run.output(), simulator::connect, simulator::cycle, feed);
    }

    /** Does what the page asks for. */
    void ask(String command) {
        feed.ask(command);
    }

    /**
     * Goes on as far as the chosen speed and the processor allow, and tells the page.
     *
     * @param seconds how long the last turn is ago
     */
    void turn(double seconds) {
        long begin = System.nanoTime();
        long before = simulator.cycles();
        owedSeconds = Math.min(owedSeconds, MOST_BEHIND_SECONDS) + seconds * speed;
        List<RobotSnapshot> watched =
                snapshot().robots().stream().filter(feed::watches).toList();
        while (mayGoOn() && System.nanoTime() - begin < LONGEST_TURN_NANOS) {
            cycle(watched);
        }
        double weight = Math.min(1, seconds / SMOOTHING_SECONDS);
        double factor = (simulator.cycles() - before) * Cycle.SECONDS / Math.max(seconds, 1e-3);
        realTimeFactor += weight * (factor - realTimeFactor);
        if (feed.isReady()) {
            feed.show(snapshot());
        }
    }

    private boolean mayGoOn() {
        return stepsLeft > 0 || (!paused && owedSeconds >= Cycle.SECONDS);
    }

    private void cycle(List<RobotSnapshot> watched) {
        stepsLeft = Math.max(0, stepsLeft - 1);
        owedSeconds -= Cycle.SECONDS;
        simulator.cycle();
        hearMessages(watched);
        player.run();
    }

    private void hearMessages(List<RobotSnapshot> watched) {
        for (RobotSnapshot robot : watched) {
            simulator.messages(id -> id == robot.id()).forEach(messages -> feed.exchanged(robot, messages));
        }
    }

    private WorldSnapshot snapshot() {
        return simulator.snapshot(paused, speed).withPace(paused, speed, realTimeFactor);
    }

    private void order(Order order) {
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
            simulator.order(order);
        }
    }

    private void hold(int cycles) {
        paused = true;
        stepsLeft = cycles;
        owedSeconds = 0;
    }
}
