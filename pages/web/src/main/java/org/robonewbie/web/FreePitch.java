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
import org.robonewbie.pagejvm.Program;

/** The beginners' world, in which everybody may do everything, with shipped agents and one program of a student. */
final class FreePitch implements EditableWorld {

    private static final String GUESTS = "Guests";
    private static final int TEAMS = 2;
    private static final double COLUMN_METRES = -2.5;
    private static final double ROW_METRES = 1.5;

    /** More than a robot needs to leave, or to enter and to stand. */
    private static final int MOST_CYCLES = 100;

    private final SteppedSimulator simulator;
    private final PageFeed feed;
    private final List<Player> players = new ArrayList<>();
    private Optional<Player> student = Optional.empty();

    /**
     * Prepares a pitch without robots.
     *
     * @param seed start of all random numbers
     * @param feed gets what happens
     * @param recording where a recording goes
     */
    FreePitch(long seed, PageFeed feed, RecordingTarget recording) {
        this.feed = feed;
        simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(seed), recording, feed::told);
        simulator.reportEventsTo(feed::happened);
    }

    /**
     * Lets an agent enter; every second robot plays against the first one.
     *
     * @param agent the agent
     * @return this pitch
     */
    FreePitch with(Agent agent) {
        AgentDriver driver = new AgentDriver(agent);
        driver.publishTo(feed);
        PatientLink link = new PatientLink(simulator.connect(this::cycle));
        try {
            driver.join(link, asNumber(players.size(), driver.usualOptions()));
        } catch (IOException impossible) {
            throw new UncheckedIOException("The world of the page has closed its connection.", impossible);
        }
        link.beBusy();
        add(new Player(driver::goOn));
        return this;
    }

    /** The first robot of each team stands where its program wants, the others stand behind. */
    private static Options asNumber(int before, Options usual) {
        Options own = usual.withSeconds(StudentProgram.FOREVER_SECONDS);
        Options ofTeam = before % TEAMS == 0 ? own : own.withTeam(GUESTS).withNumber(0);
        return before < TEAMS ? ofTeam : ofTeam.withNumber(0).withPose(COLUMN_METRES, ROW_METRES, 0);
    }

    /**
     * Lets a program of a student enter.
     *
     * @param program its classes
     * @param run gets how it goes
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
     * Lets another program take the place of the student's. If it brings the same robots, the world goes on from where it was.
     *
     * @param old the run of the program that leaves
     * @param program the classes of the other one
     * @param run gets how it goes
     */
    void swap(StudentRun old, Program program, StudentRun run) {
        simulator.isReady(); // reads what the robots have answered, which belongs to the moment
        WorldState moment = simulator.save();
        List<String> seats = seats();
        old.stop();
        student.ifPresent(players::remove);
        cycleUntil(() -> seats().size() <= players.size());
        with(program, run);
        cycleUntil(() -> seats().equals(seats) || !run.isRunning());
        if (seats().equals(seats)) {
            simulator.isReady();
            simulator.goOnFrom(moment);
        }
    }

    private void cycleUntil(BooleanSupplier condition) {
        for (int i = 0; i < MOST_CYCLES && !condition.getAsBoolean(); i++) {
            cycle();
        }
    }

    /** Who plays, and in which body. */
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
    public OptionalInt goOnFrom(WorldState state) {
        try {
            return simulator.isReady() ? OptionalInt.of(simulator.goOnFrom(state)) : OptionalInt.empty();
        } catch (IllegalArgumentException ofAnotherWorld) {
            return OptionalInt.empty();
        }
    }

    @Override
    public void goOnFrom(WorldSnapshot before, WorldSnapshot moment) {
        simulator.goOnFrom(before, moment);
    }

    @Override
    public AgentLink connect() {
        return simulator.connect(this::cycle);
    }

    @Override
    public Puppet start(AgentLink link, String team, int number, int type) {
        PagePuppet puppet = new PagePuppet(new PatientLink(link), SteeredRobot.options(team, number, type));
        Player player = new Player(puppet::goOn);
        puppet.whenLeft(() -> leave(player));
        add(player);
        return puppet;
    }

    /** A robot leaves when its next message is due, so the world goes on until then, also a paused one. */
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

    /** Somebody who has a turn in each cycle; one that waits for the world in the middle of it has no other. */
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
