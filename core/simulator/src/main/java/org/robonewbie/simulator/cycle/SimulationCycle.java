package org.robonewbie.simulator.cycle;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.recording.Participant;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.recording.RunRecorder;
import org.robonewbie.simulator.recording.Snapshots;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * The simulation loop of 20 ms cycles, without a clock or threads. A cycle reads the agents' messages, sends the
 * messages generated in the previous cycle, steps the physics, runs the referee and generates the next messages
 * (SimSpark: {@code simulationserver.cpp}).
 *
 * <p>An agent's answer to message k is therefore read after message k + 1 is generated, and its effect appears in
 * message k + 2: a delay of two cycles. Agents are served in the order in which they connected or, for agents in other
 * processes, in the {@link TurnOrder}, so that identical responses produce identical games.
 */
public final class SimulationCycle implements Restorable {

    private final SoccerWorld world;
    private final Match match;
    private final Effectors effectors;
    private final PerceptorGenerator perceptors;
    private final Console console;
    private final List<AgentSession> agents = new ArrayList<>();
    private final Map<Robot, Participant> withoutAgent = new HashMap<>();
    private final List<String> description;
    private final String settings;
    private RunRecorder recorder;
    private final boolean synchronous;
    private final RateLimitedLogger refusals;
    private Consumer<MatchEvent> reporter = event -> {};
    private final Console departures;
    private long cycle;

    /**
     * Creates an empty pitch.
     *
     * @param settings the world to simulate
     * @param recording receives the recording of the run
     * @param console output for messages to the user
     * @param departures output for the reasons why agents leave
     */
    public SimulationCycle(WorldSettings settings, RecordingTarget recording, Console console, Console departures) {
        Random seeds = new Random(settings.seed());
        this.world = world(settings);
        this.match = new Match(world, settings.parameters(), seeds.nextLong());
        this.effectors = new Effectors(world, match, settings.camera(), seeds.nextLong());
        this.perceptors = new PerceptorGenerator(world, match);
        this.console = console;
        this.departures = departures;
        this.refusals = new RateLimitedLogger(console, "The simulator");
        this.synchronous = settings.synchronous();
        this.description = settings.description();
        this.settings =
                world.settings() + "\n" + String.join("\n", settings.withSeed(0).description());
        this.recorder = RunRecorder.begin(world, recording, description);
    }

    private static SoccerWorld world(WorldSettings settings) {
        SoccerParameters parameters = settings.parameters();
        BallProperties ball = new BallProperties(
                parameters.get(SoccerParameter.BALL_RADIUS), parameters.get(SoccerParameter.BALL_MASS));
        return new SoccerWorld(parameters.field(), ball, new SparsePhysicsWorld(), settings.landscape());
    }

    /** {@return the recorder of the run} */
    public RunRecorder recorder() {
        return recorder;
    }

    /** {@return the world} */
    public SoccerWorld world() {
        return world;
    }

    /** {@return the game} */
    public Match match() {
        return match;
    }

    /** {@return the number of cycles so far} */
    public long cycle() {
        return cycle;
    }

    /** {@return the agents in the order in which they are served} */
    public List<AgentSession> agents() {
        return Collections.unmodifiableList(agents);
    }

    /**
     * Adds an agent.
     *
     * @param link its connection
     * @param strict whether sync mode waits for the agent from its first message on
     */
    public void connect(ServerLink link, boolean strict) {
        agents.add(new AgentSession(new AgentChannel(link, synchronous, strict, console)));
    }

    /**
     * Logs that a connection was refused because too many agents are connected.
     *
     * @param link the connection
     * @param limit maximum number of agents
     */
    public void reportRefused(ServerLink link, int limit) {
        refusals.warn(
                "limit",
                "closed the connection " + link.address() + " because " + limit + " agents are already connected.");
    }

    /**
     * Returns the messages exchanged in the last cycle.
     *
     * @param robots selects robots by their ids
     * @return the messages of the selected robots
     */
    public List<AgentMessages> messages(IntPredicate robots) {
        return agents.stream()
                .filter(agent -> agent.robot().isPresent() && robots.test(agent.id()))
                .map(agent -> agent.messages(cycle))
                .toList();
    }

    /** Resets the ball, objects, robots and score to their state at the start of the game. */
    public void reset() {
        match.restart();
        world.things().reset();
        for (AgentSession agent : agents) {
            agent.player().ifPresent(player -> effectors.renew(agent, player));
        }
    }

    /**
     * Removes a player's robot permanently; its agent stays connected.
     *
     * @param player the player
     */
    public void removeRobot(Player player) {
        for (AgentSession agent : agents) {
            if (agent.player().filter(player::equals).isPresent()) {
                match.teams().leave(player);
                world.removeRobot(player.robot());
                agent.loseRobot();
            }
        }
    }

    /**
     * Reads the agents' messages and removes the robots of agents that have left. Called between two cycles, so that a
     * world waiting for agents contains no stale robots.
     */
    public void readMessages() {
        for (int i = 0; i < agents.size(); ) {
            AgentSession agent = agents.get(i);
            agent.connection().read();
            if (agent.connection().hasLeft()) {
                agents.remove(i);
                disconnect(agent);
            } else {
                i++;
            }
        }
    }

    private void disconnect(AgentSession agent) {
        ServerLink link = agent.connection().link();
        boolean unnoticed = agent.robot().isEmpty() && !agent.connection().hasSpoken();
        if (!unnoticed || !link.closingReason().equals(ServerLink.HAS_LEFT)) {
            departures.say(agent + " " + link.closingReason());
        }
        agent.player().ifPresent(match.teams()::leave);
        agent.robot().ifPresent(world::removeRobot);
    }

    /** {@return the first agent that sync mode waits for} */
    public Optional<AgentSession> unsynchronisedAgent() {
        return first(agent -> !agent.connection().isSynchronised());
    }

    /** {@return the first connected agent that has not answered its last message or has never sent one} */
    public Optional<AgentSession> unansweredAgent() {
        return first(agent -> agent.connection().link().isOpen()
                && !(agent.connection().hasSpoken() && agent.connection().isSynchronised()));
    }

    /** Returns the first selected agent. Allocates nothing, because it is called in each cycle. */
    private Optional<AgentSession> first(Predicate<AgentSession> selected) {
        for (int i = 0; i < agents.size(); i++) {
            if (selected.test(agents.get(i))) {
                return Optional.of(agents.get(i));
            }
        }
        return Optional.empty();
    }

    /** Closes the connections to all agents. */
    public void closeConnections() {
        agents.forEach(agent -> agent.connection().link().close());
    }

    /**
     * Takes a snapshot of the world.
     *
     * @param paused whether the clock is paused
     * @param speed requested simulated seconds per real second
     * @param realTimeFactor measured simulated seconds per real second
     * @return the current state
     */
    public WorldSnapshot snapshot(boolean paused, double speed, double realTimeFactor) {
        return Snapshots.of(cycle, match, world, participants()).withPace(paused, speed, realTimeFactor);
    }

    /**
     * Continues from an earlier snapshot; robots that are no longer in the game are skipped.
     *
     * @param before a snapshot before {@code target}, used to derive velocities; {@code target} itself for a world at rest
     * @param target the snapshot to continue from
     */
    public void restore(WorldSnapshot before, WorldSnapshot target) {
        new Restoration(this).restore(before, target);
    }

    /**
     * Counts the connected agents that have sent a message.
     *
     * @param team the team whose port the agents use; empty for agents on the common port
     * @return their number
     */
    public int speakingAgents(Optional<String> team) {
        return (int) agents.stream()
                .filter(agent -> agent.connection().hasSpoken())
                .filter(agent -> agent.connection().link().team().equals(team))
                .count();
    }

    /** {@return whether any connection is open} */
    public boolean hasConnectedAgent() {
        return agents.stream().anyMatch(agent -> agent.connection().link().isOpen());
    }

    /**
     * Sets the listener for match events.
     *
     * @param newReporter the listener
     */
    public void reportEventsTo(Consumer<MatchEvent> newReporter) {
        reporter = newReporter;
    }

    /** Runs one cycle with the messages read so far. */
    public void run() {
        for (AgentSession agent : agents) {
            effectors.execute(agent, agents);
        }
        TurnOrder.arrange(agents);
        agents.forEach(agent -> agent.connection().send());
        for (AgentSession agent : agents) {
            agent.beginCycle();
            effectors.prepareStep(agent);
        }
        recorder.beforeStep(participants());
        world.step();
        recorder.afterStep();
        cycle++;
        perceptors.takePictures(agents);
        match.tick();
        recorder.cycleEnded(cycle, match, participants());
        reportSelfCollisions();
        match.events().forEach(reporter);
        match.clearEvents();
        generateMessages();
    }

    private void reportSelfCollisions() {
        if (match.parameters().isOn(SoccerParameter.PRINT_SELF_COLLISIONS)) {
            for (MatchEvent event : match.events()) {
                if (event instanceof MatchEvent.FoulCalled called && called.foul() == FoulType.SELF_COLLISION) {
                    console.say("Limbs of player " + called.number() + " of "
                            + match.teams().name(called.side()) + " collided.");
                }
            }
        }
    }

    private List<Participant> participants() {
        List<Participant> all = new ArrayList<>(agents.size());
        agents.forEach(agent -> agent.addParticipantTo(all));
        if (all.size() < world.robots().size()) {
            addWithoutAgent(all);
        }
        return all;
    }

    /** Adds the robots that no agent controls because a program has added them to the world. */
    private void addWithoutAgent(List<Participant> all) {
        withoutAgent.keySet().retainAll(world.robots());
        for (Robot robot : world.robots()) {
            if (all.stream().noneMatch(participant -> participant.robot() == robot)) {
                all.add(withoutAgent.computeIfAbsent(
                        robot, added -> new Participant(effectors.nextId(), Optional.empty(), added, List.of(), 0)));
            }
        }
    }

    private void generateMessages() {
        for (AgentSession agent : agents) {
            if (agent.robot().isPresent() && !agent.isNewborn()) {
                generateMessage(agent, agent.robot().get());
            }
        }
    }

    private void generateMessage(AgentSession agent, Robot robot) {
        MessageBuffer message = agent.connection().emptyMessage();
        new PerceptorMessageWriter(message).write(perceptors.of(agent, robot, cycle * Cycle.SECONDS));
        agent.connection().messageGenerated();
    }

    /** {@return the exact state of the world, the game, the agents and the messages in transit} */
    public WorldState save() {
        readMessages();
        return WorldState.of(settings, this);
    }

    /**
     * Continues from a saved state. Each saved agent is matched to a connected one: by team and number, then by robot id,
     * and finally by picking any agent without a robot. A saved agent without a match is replaced with a robot that
     * does not move. Connected agents without a match stay connected without a robot.
     *
     * <p>The recording ends; a new one without a file begins.
     *
     * @param state the state of a simulation with the same settings
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public void restore(WorldState state) {
        state.restore(settings, this);
        recorder.close();
        recorder = RunRecorder.begin(world, RecordingTarget.NONE, description);
    }

    @Override
    public void save(StateWriter out) {
        world.save(out);
        match.save(out);
        effectors.save(out);
        out.putLong(cycle);
        AgentSlot.saveAll(agents, world.robots(), match, out);
    }

    @Override
    public void restore(StateReader in) {
        agents.removeIf(AgentSession::isAbsent);
        world.restore(in);
        match.restore(in);
        effectors.restore(in);
        cycle = in.getLong();
        AgentSlot.restoreAll(agents, world.robots(), match, () -> effectors.newCamera(0), this::absentAgent, in);
    }

    /**
     * Applies a saved state to the running simulation: the cycle counter, the robot ids and the recording continue. Saved messages
     * in transit are dropped because their time stamps are outdated.
     *
     * @param state the state of a simulation with the same settings
     * @return the number of agents whose own state was also restored
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public int resumeFrom(WorldState state) {
        long now = cycle;
        int robots = effectors.createdRobots();
        Map<AgentSession, Integer> ids = new HashMap<>();
        agents.forEach(agent -> ids.put(agent, agent.id()));
        state.restore(settings, this);
        cycle = now;
        effectors.setCreatedRobots(robots);
        for (AgentSession agent : agents) {
            agent.connection().emptyMessage();
            int id = ids.getOrDefault(agent, 0);
            agent.setId(id > 0 || agent.robot().isEmpty() ? id : effectors.nextId());
        }
        return (int)
                agents.stream().filter(agent -> agent.connection().isRestored()).count();
    }

    private AgentSession absentAgent() {
        return new AgentSession(new AgentChannel(new AbsentLink(), synchronous, true, console));
    }
}
