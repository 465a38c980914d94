package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.recording.RunReport;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * A whole simulator in the hand of its owner: without thread, clock, port or file. The world goes on by {@link #cycle}, or by itself
 * when an agent waits for its next message.
 *
 * <pre>{@code
 * SteppedSimulator simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(1), Console.silent());
 * AgentLink agent = simulator.connect();
 * agent.send(message);
 * agent.receive(message);   // runs as many cycles as it takes
 * }</pre>
 *
 * <p>Several agents take turns: each of them sends its answer before the first one waits for the next message. Not for several
 * threads.
 */
public final class SteppedSimulator implements AutoCloseable {

    private final WorldSettings settings;
    private final SimulationCycle cycle;
    private final TrainerOrders trainer;
    private double lastCycle = Double.POSITIVE_INFINITY;

    private SteppedSimulator(WorldSettings settings, SimulationCycle cycle) {
        this.settings = settings;
        this.cycle = cycle;
        this.trainer = new TrainerOrders(cycle, () -> {}, cycle::closeConnections);
    }

    /**
     * Prepares the pitch.
     *
     * @param settings what the world is like; it should be synchronous
     * @param console where it tells people what happens
     * @return the simulator, before its first cycle
     */
    public static SteppedSimulator start(WorldSettings settings, Console console) {
        return start(settings, RecordingTarget.NONE, console);
    }

    /**
     * Prepares the pitch and begins a recording.
     *
     * @param settings what the world is like; it should be synchronous
     * @param recording where the recording goes
     * @param console where it tells people what happens
     * @return the simulator, before its first cycle
     */
    public static SteppedSimulator start(WorldSettings settings, RecordingTarget recording, Console console) {
        return new SteppedSimulator(settings, new SimulationCycle(settings, recording, console));
    }

    /**
     * Lets the world end by itself.
     *
     * @param seconds simulated seconds after which agents receive no more messages
     */
    public void endAfter(double seconds) {
        lastCycle = PortableMath.rint(seconds / Cycle.SECONDS);
    }

    /**
     * Connects an agent.
     *
     * @return the agent's end
     */
    public AgentLink connect() {
        return connect(this::cycle);
    }

    /**
     * Connects an agent among others of the same thread.
     *
     * @param turn called again and again while the agent waits for a message: lets the others answer, and calls {@link #cycle}
     * @return the agent's end
     */
    public AgentLink connect(Runnable turn) {
        SteppedLink link = new SteppedLink(turn);
        cycle.connect(link.worldEnd(), true);
        return link;
    }

    /**
     * Connects an agent of another process.
     *
     * @param link the simulator's end of its connection
     */
    public void connect(ServerLink link) {
        cycle.connect(link, true);
    }

    /** {@return whether each agent has sent its answer, which ends with {@code (syn)}} */
    public boolean isReady() {
        return missingAgent().isEmpty();
    }

    private Optional<AgentSession> missingAgent() {
        cycle.readMessages();
        return cycle.unansweredAgent();
    }

    /**
     * Runs one cycle. Each agent must have sent its answer.
     *
     * @throws IllegalStateException if an agent has not answered
     */
    public void cycle() {
        Optional<AgentSession> missing = missingAgent();
        if (missing.isPresent()) {
            throw new IllegalStateException("The world cannot go on: " + missing.get()
                    + " has not answered its last message. Agents of one thread take turns.");
        }
        cycle.run();
        if (cycle.cycle() >= lastCycle || cycle.match().isProgramOver()) {
            cycle.closeConnections();
        }
    }

    /** {@return the number of cycles so far} */
    public long cycles() {
        return cycle.cycle();
    }

    /** {@return the world with its robots in the order in which they were created} */
    public SoccerWorld world() {
        return cycle.world();
    }

    /** {@return the match on this pitch} */
    public Match match() {
        return cycle.match();
    }

    /**
     * Takes a picture of the world, as observers of a running simulation get it.
     *
     * @param paused whether the owner holds the world
     * @param speed simulated seconds per second, as the owner keeps it
     * @return the present state
     */
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return cycle.snapshot(paused, speed, speed);
    }

    /**
     * Lists what robots and their agents have said to each other in the last cycle.
     *
     * @param robots whose messages are wanted, by the numbers of their connections
     * @return the messages of those that have a robot
     */
    public List<AgentMessages> messages(IntPredicate robots) {
        return cycle.messages(robots);
    }

    /**
     * Carries out an order before the next cycle.
     *
     * @param order the order; orders to the clock are those of its owner
     */
    public void order(Order order) {
        trainer.execute(order);
    }

    /**
     * Reports what happens in the game.
     *
     * @param reporter called within {@link #cycle}
     */
    public void reportEventsTo(Consumer<MatchEvent> reporter) {
        cycle.reportEventsTo(reporter);
    }

    /** {@return the true results so far, without the time that they took} */
    public RunReport report() {
        return cycle.recorder().report(settings.seed(), 0, 0);
    }

    /** {@return the whole state, from which this simulator or one with the same settings goes on to the bit} */
    public WorldState save() {
        return cycle.save();
    }

    /**
     * Goes on from a saved state. Agents that are connected keep their connections and get back their robots; a new recording
     * begins. What an agent remembers is its own business: see {@link org.robonewbie.nao.state.Restorable}.
     *
     * @param state the state of a simulation with the same settings
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public void restore(WorldState state) {
        cycle.restore(state);
    }

    /**
     * Goes on from a saved state as if it had come about just now: the count of cycles, the numbers of the robots and the recording
     * go on. Messages that were under way are left out.
     *
     * @param state the state of a simulation with the same settings
     * @return how many agents have taken on their own states as well
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public int resumeFrom(WorldState state) {
        return cycle.resumeFrom(state);
    }

    /**
     * Goes on nearly from a state that was seen before; robots that do not play now are left out.
     *
     * @param before an earlier state, from which the velocities are taken; the same state for a world at rest
     * @param moment the state to go on from
     */
    public void resumeFrom(WorldSnapshot before, WorldSnapshot moment) {
        cycle.restore(before, moment);
    }

    @Override
    public void close() {
        cycle.closeConnections();
        cycle.recorder().close();
    }
}
