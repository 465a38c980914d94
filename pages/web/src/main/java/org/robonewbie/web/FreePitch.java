package org.robonewbie.web;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.puppet.SteeredRobot;
import org.robonewbie.pagejvm.Program;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.studio.PageFeed;

/** Free play in the beginners' world: example agents, manually controlled robots (puppets) and one student's program. */
final class FreePitch implements EditableWorld {

    private static final String GUESTS = "Guests";
    private static final int TEAMS = 2;
    private static final double COLUMN_METRES = -2.5;
    private static final double ROW_METRES = 1.5;

    /** Maximum number of cycles to wait until a robot has left, or has joined and is standing still. */
    private static final int MAX_CYCLES = 100;

    private final SteppedSimulator simulator;
    private final PageFeed feed;
    private final List<Player> players = new ArrayList<>();
    private Optional<Player> student = Optional.empty();

    /**
     * Creates a pitch without robots.
     *
     * @param seed random seed
     * @param feed receives the messages
     * @param recording destination of the recording
     */
    FreePitch(long seed, PageFeed feed, RecordingTarget recording) {
        this.feed = feed;
        simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(seed), recording, feed::messagePrinted);
        simulator.reportEventsTo(feed::happened);
    }

    /**
     * Adds an agent; every second robot joins the opposing team.
     *
     * @param agent the agent
     * @return this pitch
     */
    FreePitch with(Agent agent) {
        AgentDriver driver = new AgentDriver(agent);
        driver.publishTo(feed);
        PatientLink link = new PatientLink(simulator.connect(this::cycle));
        try {
            driver.join(link, asNumber(players.size(), driver.defaultOptions()));
        } catch (IOException impossible) {
            throw new UncheckedIOException("The simulator on this page has closed the connection.", impossible);
        }
        link.stopWaiting();
        add(new Player(driver::resume));
        return this;
    }

    /** Returns a robot's options. The first robot of each team starts at the pose that its program requests; the others start behind it. */
    private static Options asNumber(int before, Options usual) {
        Options own = usual.withSeconds(StudentProgram.FOREVER_SECONDS);
        Options ofTeam = before % TEAMS == 0 ? own : own.withTeam(GUESTS).withNumber(0);
        return before < TEAMS ? ofTeam : ofTeam.withNumber(0).withPose(COLUMN_METRES, ROW_METRES, 0);
    }

    /**
     * Adds a student's program.
     *
     * @param program the program's classes
     * @param run tracks the state of the program
     * @return this pitch
     */
    FreePitch with(Program program, StudentRun run) {
        Player entered =
                new Player(run.begin(new StudentProgram(program, run.output(), simulator::connect, this::cycle, feed)));
        student = Optional.of(entered);
        add(entered);
        return this;
    }

    private void add(Player player) {
        players.add(player);
        player.play();
    }

    /**
     * Replaces the student's program. The state of the world is kept if the new program has the same robots.
     *
     * @param old run of the old program
     * @param program classes of the new program
     * @param run tracks the state of the new program
     */
    void swap(StudentRun old, Program program, StudentRun run) {
        simulator.isReady(); // reads the robots' responses, which belong to the saved state
        WorldState moment = simulator.save();
        List<String> seats = seats();
        old.stop();
        feed.clearTelemetry();
        student.ifPresent(players::remove);
        cycleUntil(() -> seats().size() <= players.size());
        with(program, run);
        cycleUntil(() -> seats().equals(seats) || !run.isRunning());
        if (seats().equals(seats)) {
            simulator.isReady();
            simulator.resumeFrom(moment);
        }
    }

    private void cycleUntil(BooleanSupplier condition) {
        for (int i = 0; i < MAX_CYCLES && !condition.getAsBoolean(); i++) {
            cycle();
        }
    }

    /** Returns the identities and body types of all robots. */
    private List<String> seats() {
        return simulator.snapshot(false, 1).robots().stream()
                .map(robot -> robot.team() + " " + robot.number() + " " + robot.side() + " " + robot.type())
                .sorted()
                .toList();
    }

    @Override
    public Optional<WorldState> save() {
        return simulator.isReady() ? Optional.of(simulator.save()) : Optional.empty();
    }

    @Override
    public OptionalInt restore(WorldState state) {
        try {
            return simulator.isReady() ? OptionalInt.of(simulator.resumeFrom(state)) : OptionalInt.empty();
        } catch (IllegalArgumentException ofAnotherWorld) {
            return OptionalInt.empty();
        }
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        simulator.resumeFrom(before, moment);
    }

    @Override
    public AgentLink connect() {
        return simulator.connect(this::cycle);
    }

    @Override
    public Puppet start(AgentLink link, String team, int number, int type) {
        PagePuppet puppet = new PagePuppet(new PatientLink(link), SteeredRobot.options(team, number, type));
        Player player = new Player(puppet::turn);
        puppet.whenLeft(() -> leave(player));
        add(player);
        return puppet;
    }

    /** Removes a robot. It leaves when its next message is due, so the world is advanced until then, even if paused. */
    private void leave(Player player) {
        int before = seats().size();
        players.remove(player);
        cycleUntil(() -> {
            simulator.isReady();
            return seats().size() < before;
        });
    }

    @Override
    public void cycle() {
        simulator.cycle();
        players.forEach(Player::play);
    }

    /**
     * A participant that acts once per cycle. If its action advances the world by further cycles, it does not act in them.
     */
    private static final class Player {

        private final Runnable turn;
        private boolean busy;

        Player(Runnable turn) {
            this.turn = turn;
        }

        void play() {
            if (!busy) {
                busy = true;
                try {
                    turn.run();
                } finally {
                    busy = false;
                }
            }
        }
    }

    @Override
    public boolean isOver() {
        return false;
    }

    @Override
    public long cycles() {
        return simulator.cycles();
    }

    @Override
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return simulator.snapshot(paused, speed);
    }

    @Override
    public void order(Order order) {
        simulator.order(order);
    }

    @Override
    public List<AgentMessages> messages(IntPredicate robots) {
        return simulator.messages(robots);
    }
}
