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
 * A simulator that its owner steps manually, without a thread, clock, port or file. It advances when {@link #cycle} is
 * called or an agent waits for its next message.
 *
 * <pre>{@code
 * SteppedSimulator simulator = SteppedSimulator.start(WorldSettings.beginner().withSeed(1), Console.silent());
 * AgentLink agent = simulator.connect();
 * agent.send(message);
 * agent.receive(message);   // runs cycles until a message arrives
 * }</pre>
 *
 * <p>With several agents, all must have sent their answers before one of them waits for its next message. Not thread-safe.
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
     * Creates a simulator without a recording.
     *
     * @param settings the world to simulate; should be synchronous
     * @param console output for messages to the user
     * @return the simulator, which has not run any cycle yet
     */
    public static SteppedSimulator start(WorldSettings settings, Console console) {
        return start(settings, RecordingTarget.NONE, console);
    }

    /**
     * Creates a simulator with a recording.
     *
     * @param settings the world to simulate; should be synchronous
     * @param recording receives the recording
     * @param console output for messages to the user
     * @return the simulator, which has not run any cycle yet
     */
    public static SteppedSimulator start(WorldSettings settings, RecordingTarget recording, Console console) {
        return new SteppedSimulator(settings, new SimulationCycle(settings, recording, console, Console.silent()));
    }

    /**
     * Sets the end of the simulation.
     *
     * @param seconds simulated seconds after which all agents are disconnected
     */
    public void endAfter(double seconds) {
        lastCycle = PortableMath.rint(seconds / Cycle.SECONDS);
    }

    /**
     * Connects an agent.
     *
     * @return the agent's end of the connection
     */
    public AgentLink connect() {
        return connect(this::cycle);
    }

    /**
     * Connects one of several agents that run on this thread.
     *
     * @param turn called repeatedly while the agent waits for a message; must let the other agents answer, and must then call {@link #cycle}
     * @return the agent's end of the connection
     */
    public AgentLink connect(Runnable turn) {
        SteppedLink link = new SteppedLink(turn);
        cycle.connect(link.serverEnd(), true);
        return link;
    }

    /**
     * Connects an agent in another process.
     *
     * @param link the simulator's end of its connection
     */
    public void connect(ServerLink link) {
        cycle.connect(link, true);
    }

    /** {@return whether each agent has sent an answer that ends with {@code (syn)}} */
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
            throw new IllegalStateException(
                    "The next cycle cannot start: " + missing.get()
                            + " has not answered its last message. Let each agent of this thread answer before any agent waits.");
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

    /**
     * {@return the world with its robots in order of creation; a robot that is added to it takes part in the simulation, and the owner
     * of the simulator commands its motors}
     */
    public SoccerWorld world() {
        return cycle.world();
    }

    /** {@return the match on this pitch} */
    public Match match() {
        return cycle.match();
    }

    /**
     * Takes a snapshot of the world for observers.
     *
     * @param paused whether the owner has paused the simulation
     * @param speed simulated seconds per real second
     * @return the current state
     */
    public WorldSnapshot snapshot(boolean paused, double speed) {
        return cycle.snapshot(paused, speed, speed);
    }

    /**
     * Returns the messages exchanged in the last cycle.
     *
     * @param robots selects robots by their ids
     * @return the messages of the selected robots
     */
    public List<AgentMessages> messages(IntPredicate robots) {
        return cycle.messages(robots);
    }

    /**
     * Executes a command before the next cycle.
     *
     * @param order the command; clock commands are ignored
     */
    public void order(Order order) {
        trainer.execute(order);
    }

    /**
     * Sets the listener for match events.
     *
     * @param reporter called during {@link #cycle}
     */
    public void reportEventsTo(Consumer<MatchEvent> reporter) {
        cycle.reportEventsTo(reporter);
    }

    /** {@return the results so far, without wall-clock times} */
    public RunReport report() {
        return cycle.recorder().report(settings.seed(), 0, 0);
    }

    /** {@return the exact state, which this simulator or one with the same settings can restore} */
    public WorldState save() {
        return cycle.save();
    }

    /**
     * Continues from a saved state. Connected agents keep their connections and regain their robots; a new recording begins.
     * An agent's own memory is restored only if it offers its state: see {@link org.robonewbie.nao.state.Restorable}.
     *
     * @param state the state of a simulation with the same settings
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public void restore(WorldState state) {
        cycle.restore(state);
    }

    /**
     * Applies a saved state to the running simulation: the cycle counter, the robot ids and the recording continue. Saved messages
     * in transit are dropped.
     *
     * @param state the state of a simulation with the same settings
     * @return the number of agents whose own state was also restored
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public int resumeFrom(WorldState state) {
        return cycle.resumeFrom(state);
    }

    /**
     * Continues approximately from an earlier snapshot; robots that are no longer in the game are skipped.
     *
     * @param before a snapshot before {@code target}, used to derive velocities; {@code target} itself for a world at rest
     * @param target the snapshot to continue from
     */
    public void resumeFrom(WorldSnapshot before, WorldSnapshot target) {
        cycle.restore(before, target);
    }

    @Override
    public void close() {
        cycle.closeConnections();
        cycle.recorder().close();
    }
}
