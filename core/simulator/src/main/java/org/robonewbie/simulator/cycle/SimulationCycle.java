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
 * One cycle of 20 ms after the other, without clock and threads: read the agents' messages, send them what was generated in
 * the cycle before, move the world, judge the game, generate the next messages (SimSpark: {@code simulationserver.cpp}).
 *
 * <p>So an agent's answer to message k is read when message k + 1 has already been generated, and shows its effect in message
 * k + 2. Agents are served in the order in which they connected or, in other processes, in the {@link TurnOrder}, so that
 * equal answers give equal games.
 */
public final class SimulationCycle implements Restorable {

    private final SoccerWorld world;
    private final Match match;
    private final Effectors effectors;
    private final PerceptorGenerator perceptors;
    private final Console console;
    private final List<AgentSession> agents = new ArrayList<>();
    private final List<String> description;
    private final String settings;
    private RunRecorder recorder;
    private final boolean synchronous;
    private final RateLimitedLogger refusals;
    private Consumer<MatchEvent> reporter = event -> {};
    private long cycle;

    /**
     * Prepares an empty pitch.
     *
     * @param settings what the world is like
     * @param recording where the recording of the run goes
     * @param console where to tell people what happens
     */
    public SimulationCycle(WorldSettings settings, RecordingTarget recording, Console console) {
        Random seeds = new Random(settings.seed());
        this.world = world(settings);
        this.match = new Match(world, settings.parameters(), seeds.nextLong());
        this.effectors = new Effectors(world, match, settings.camera(), seeds.nextLong());
        this.perceptors = new PerceptorGenerator(world, match);
        this.console = console;
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

    /** {@return what watches the run} */
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
     * Takes in an agent.
     *
     * @param link its connection
     * @param strict whether in sync mode it is waited for from its first message on
     */
    public void connect(ServerLink link, boolean strict) {
        agents.add(new AgentSession(new AgentChannel(link, synchronous, strict, console)));
    }

    /**
     * Reports a connection that was closed at once since there are too many.
     *
     * @param link the connection
     * @param limit how many agents there may be
     */
    public void refused(ServerLink link, int limit) {
        refusals.warn(
                "limit",
                "had to close the connection " + link.address() + ", since " + limit
                        + " agents are connected already.");
    }

    /**
     * Lists what robots and their agents have said to each other in the last cycle.
     *
     * @param robots whose messages are wanted, by the numbers of their connections
     * @return the messages of those that have a robot
     */
    public List<AgentMessages> messages(IntPredicate robots) {
        return agents.stream()
                .filter(agent -> agent.robot().isPresent() && robots.test(agent.id()))
                .map(agent -> agent.messages(cycle))
                .toList();
    }

    /** Resets ball, things, robots and score to the start of the game. */
    public void reset() {
        match.restart();
        world.things().reset();
        for (AgentSession agent : agents) {
            agent.player().ifPresent(player -> effectors.renew(agent, player));
        }
    }

    /**
     * Takes a player's robot off the pitch for good; its agent stays connected.
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
     * Reads what the agents have sent, and takes those that have left off the pitch: between two cycles, so that a world that
     * waits for agents and has none left shows no robot of theirs.
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
        boolean unnoticed = agent.robot().isEmpty() && !agent.connection().isHeardOf();
        if (!unnoticed || !link.closingReason().equals(ServerLink.HAS_LEFT)) {
            console.say(agent + " " + link.closingReason());
        }
        agent.player().ifPresent(match.teams()::leave);
        agent.robot().ifPresent(world::removeRobot);
    }

    /** {@return the first agent for whose answer a synchronous world waits} */
    public Optional<AgentSession> unsynchronisedAgent() {
        return first(agent -> !agent.connection().isSynchronised());
    }

    /** {@return the first agent that is still there and has not yet answered, or has not said anything at all} */
    public Optional<AgentSession> unansweredAgent() {
        return first(agent -> agent.connection().link().isOpen()
                && !(agent.connection().isHeardOf() && agent.connection().isSynchronised()));
    }

    private Optional<AgentSession> first(Predicate<AgentSession> wanted) {
        for (int i = 0; i < agents.size(); i++) {
            if (wanted.test(agents.get(i))) {
                return Optional.of(agents.get(i));
            }
        }
        return Optional.empty();
    }

    /** Ends the connections to all agents. */
    public void closeConnections() {
        agents.forEach(agent -> agent.connection().link().close());
    }

    /**
     * Takes a picture of the world.
     *
     * @param paused whether the clock stands still
     * @param speed simulated seconds per second that were asked for
     * @param realTimeFactor simulated seconds per second, as measured
     * @return the present state
     */
    public WorldSnapshot snapshot(boolean paused, double speed, double realTimeFactor) {
        return Snapshots.of(cycle, match, world, participants()).withPace(paused, speed, realTimeFactor);
    }

    /**
     * Lets the world go on from a state that was seen before; robots that do not play now are left out.
     *
     * @param before an earlier state, from which the velocities are taken
     * @param moment the state to go on from
     */
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        new Restoration(this).restore(before, moment);
    }

    /**
     * Counts agents that are connected and have sent something.
     *
     * @param team the team whose door they came through; empty for those who came through none
     * @return their number
     */
    public int heardAgents(Optional<String> team) {
        return (int) agents.stream()
                .filter(agent -> agent.connection().isHeardOf(team))
                .count();
    }

    /** {@return whether an agent is at the other end of any connection} */
    public boolean isAnybodyConnected() {
        return agents.stream().anyMatch(agent -> agent.connection().link().isOpen());
    }

    /**
     * Sets the listener that is told of match events.
     *
     * @param newReporter the listener
     */
    public void reportEventsTo(Consumer<MatchEvent> newReporter) {
        reporter = newReporter;
    }

    /** Does all that belongs to one cycle, with the messages that have been read. */
    public void run() {
        for (AgentSession agent : agents) {
            effectors.execute(agent, agents);
        }
        TurnOrder.arrange(agents);
        agents.forEach(agent -> agent.connection().send());
        for (AgentSession agent : agents) {
            agent.cycleBegins();
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
                            + match.teams().name(called.side()) + " ran into each other.");
                }
            }
        }
    }

    private List<Participant> participants() {
        List<Participant> all = new ArrayList<>(agents.size());
        agents.forEach(agent -> agent.addParticipantTo(all));
        return all;
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

    /** {@return the state of world, game, agents and messages under way, from which a world like this one goes on to the bit} */
    public WorldState save() {
        readMessages();
        return WorldState.of(settings, this);
    }

    /**
     * Goes on from a saved state. Each agent of that time is looked for among those that are connected now, by team and number,
     * then by the number of its robot, and at last any agent without robot takes its place; who is not found is stood in for by
     * a robot that does not move. Agents for whom the state has no place stay connected without robot.
     *
     * <p>A new recording begins, without file: the old one ends at this moment.
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
     * Takes on a saved state as if it had come about just now: the count of cycles, the numbers of the robots and the recording
     * go on. Messages that were under way are left out, since the time in them is over.
     *
     * @param state the state of a simulation with the same settings
     * @return how many agents have taken on their own states as well
     * @throws IllegalArgumentException if the settings differ or the state is damaged
     */
    public int resumeFrom(WorldState state) {
        long now = cycle;
        int robots = effectors.createdRobots();
        Map<AgentSession, Integer> ids = new HashMap<>();
        agents.forEach(agent -> ids.put(agent, agent.id()));
        state.restore(settings, this);
        cycle = now;
        effectors.countOnFrom(robots);
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
