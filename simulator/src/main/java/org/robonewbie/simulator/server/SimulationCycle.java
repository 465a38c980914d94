package org.robonewbie.simulator.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.protocol.perceptor.PerceptorMessageWriter;
import org.robonewbie.simulator.recording.Participant;
import org.robonewbie.simulator.recording.RunRecorder;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.MatchEvent;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * One cycle of 20 ms after the other, without clock and threads: read the agents' messages, send them what was generated in
 * the cycle before, move the world, judge the game, generate the next messages (SimSpark: {@code simulationserver.cpp}).
 *
 * <p>So an agent's answer to message k is read when message k + 1 has already been generated, and shows its effect in message
 * k + 2. Agents are served in the order in which they connected or, in other processes, in the {@link OrderOfArrival}, so that
 * equal answers give equal games.
 */
final class SimulationCycle {

    private static final double CYCLE_SECONDS = 0.02;

    private final SoccerWorld world;
    private final Match match;
    private final Effectors effectors;
    private final Percepts percepts;
    private final Console console;
    private final List<ConnectedAgent> agents = new ArrayList<>();
    private final RunRecorder recorder;
    private final boolean synchronous;
    private final ComplaintBook refusals;
    private Consumer<MatchEvent> reporter = event -> {};
    private long cycle;

    private SimulationCycle(SimulatorSettings settings, SoccerWorld world, Console console, RunRecorder recorder) {
        Random seeds = new Random(settings.seed());
        this.world = world;
        this.match = new Match(world, settings.parameters(), seeds.nextLong());
        this.effectors = new Effectors(world, match, settings.camera(), seeds.nextLong());
        this.percepts = new Percepts(world, match);
        this.console = console;
        this.refusals = new ComplaintBook(console, "The simulator");
        this.synchronous = settings.synchronous();
        this.recorder = recorder;
    }

    /**
     * Prepares an empty pitch.
     *
     * @throws IOException if the recording cannot be written; the message says what to do
     */
    static SimulationCycle begin(SimulatorSettings settings, Console console) throws IOException {
        SoccerParameters parameters = settings.parameters();
        BallProperties ball = new BallProperties(
                parameters.get(SoccerParameter.BALL_RADIUS), parameters.get(SoccerParameter.BALL_MASS));
        SoccerWorld world =
                new SoccerWorld(parameters.field(), ball, settings.physics().newWorld());
        RunRecorder recorder = RunRecorder.begin(world, settings.recording(), settings.description(), console::say);
        return new SimulationCycle(settings, world, console, recorder);
    }

    RunRecorder recorder() {
        return recorder;
    }

    SoccerWorld world() {
        return world;
    }

    Match match() {
        return match;
    }

    /** Tells how many cycles are over. */
    long cycle() {
        return cycle;
    }

    /** Lists the agents in the order in which they are served. */
    List<ConnectedAgent> agents() {
        return Collections.unmodifiableList(agents);
    }

    /**
     * Takes in an agent.
     *
     * @param link its connection
     * @param strict whether in sync mode it is waited for from its first message on
     */
    void connect(ServerLink link, boolean strict) {
        agents.add(new ConnectedAgent(new AgentConnection(link, synchronous, strict, console)));
    }

    /** Tells that a connection was closed at once since there are too many. */
    void refused(ServerLink link, int limit) {
        refusals.complain(
                "limit",
                "had to close the connection " + link.address() + ", since " + limit
                        + " agents are connected already.");
    }

    /** Puts ball, robots and score back to the start of the game. */
    void reset() {
        match.restart();
        for (ConnectedAgent agent : agents) {
            agent.player().ifPresent(player -> effectors.renew(agent, player));
        }
    }

    /** Puts the ball somewhere. */
    void placeBall(Vector3 position, Vector3 velocity) {
        world.ball().moveTo(position);
        world.ball().setVelocity(velocity);
    }

    /** Lets a team kick off from the centre spot. */
    void kickOff(TeamSide side) {
        match.kickOff(side);
        world.ball().place(new Vector3(0, 0, world.ball().properties().radius()));
    }

    /** Takes a player's robot off the pitch for good; its agent stays connected. */
    void removeRobot(Player player) {
        for (ConnectedAgent agent : agents) {
            if (agent.player().filter(player::equals).isPresent()) {
                match.teams().leave(player);
                world.removeRobot(player.robot());
                agent.loseRobot();
            }
        }
    }

    /** Reads what the agents have sent, and forgets those that left before they had a robot. */
    void readMessages() {
        boolean anybodyLeft = false;
        for (int i = 0; i < agents.size(); i++) {
            agents.get(i).connection().read();
            anybodyLeft |= agents.get(i).connection().hasLeft();
        }
        if (anybodyLeft) {
            agents.removeIf(agent -> agent.robot().isEmpty() && hasLeft(agent));
        }
    }

    /** Finds the first agent that has not yet answered. */
    Optional<ConnectedAgent> unsynchronisedAgent() {
        for (int i = 0; i < agents.size(); i++) {
            if (!agents.get(i).connection().isSynchronised()) {
                return Optional.of(agents.get(i));
            }
        }
        return Optional.empty();
    }

    /** Counts the agents that are connected and have sent something. */
    int heardAgents() {
        return (int) agents.stream()
                .filter(agent ->
                        agent.connection().isHeardOf() && !agent.connection().hasLeft())
                .count();
    }

    /** Tells whether an agent is at the other end of any connection. */
    boolean isAnybodyConnected() {
        return agents.stream().anyMatch(agent -> agent.connection().link().isOpen());
    }

    /** Finds somebody who wants to know what happens in the game. */
    void reportEventsTo(Consumer<MatchEvent> newReporter) {
        reporter = newReporter;
    }

    /** Does all that belongs to one cycle, with the messages that have been read. */
    void run() {
        for (ConnectedAgent agent : agents) {
            effectors.execute(agent, agents);
        }
        OrderOfArrival.arrange(agents);
        for (ConnectedAgent agent : agents) {
            agent.connection().send();
        }
        for (ConnectedAgent agent : agents) {
            agent.cycleBegins();
            effectors.prepareStep(agent);
        }
        recorder.beforeStep(participants());
        world.step();
        recorder.afterStep();
        cycle++;
        removeVanishedAgents();
        percepts.takePictures(agents);
        match.tick();
        recorder.cycleEnded(cycle, match, participants());
        tellSelfCollisions();
        match.events().forEach(reporter);
        match.clearEvents();
        generateMessages();
    }

    private void tellSelfCollisions() {
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
        List<Participant> participants = new ArrayList<>(agents.size());
        for (ConnectedAgent agent : agents) {
            AgentConnection connection = agent.connection();
            agent.robot()
                    .ifPresent(robot -> participants.add(new Participant(
                            agent.id(),
                            agent.player(),
                            robot,
                            connection.executedCommands(),
                            connection.unansweredMessages())));
        }
        return participants;
    }

    private void removeVanishedAgents() {
        for (int i = agents.size() - 1; i >= 0; i--) {
            ConnectedAgent agent = agents.get(i);
            if (hasLeft(agent)) {
                agents.remove(i);
                agent.player().ifPresent(match.teams()::leave);
                agent.robot().ifPresent(world::removeRobot);
            }
        }
    }

    private boolean hasLeft(ConnectedAgent agent) {
        if (!agent.connection().hasLeft()) {
            return false;
        }
        ServerLink link = agent.connection().link();
        boolean unnoticed = agent.robot().isEmpty() && !agent.connection().isHeardOf();
        if (!unnoticed || !link.closingReason().equals(ServerLink.HAS_LEFT)) {
            console.say(agent + " " + link.closingReason());
        }
        return true;
    }

    private void generateMessages() {
        for (ConnectedAgent agent : agents) {
            if (agent.robot().isPresent() && !agent.isNewborn()) {
                generateMessage(agent, agent.robot().get());
            }
        }
    }

    private void generateMessage(ConnectedAgent agent, Robot robot) {
        MessageBuffer message = agent.connection().emptyMessage();
        new PerceptorMessageWriter(message).write(percepts.of(agent, robot, cycle * CYCLE_SECONDS));
        agent.connection().messageGenerated();
    }
}
