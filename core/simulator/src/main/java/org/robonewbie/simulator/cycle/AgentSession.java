package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.AgentMessages;
import org.robonewbie.simulator.recording.Participant;
import org.robonewbie.simulator.sensing.Camera;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.world.Robot;

/** An agent with its connection, its robot and what it asked for in this cycle. */
public final class AgentSession {

    private final AgentChannel connection;
    private final Hearing hearing = new Hearing();
    private int id;
    private Optional<Robot> robot = Optional.empty();
    private Optional<Camera> camera = Optional.empty();
    private Optional<Vision> picture = Optional.empty();
    private Optional<Player> player = Optional.empty();
    private Optional<CreateRobot> wantedRobot = Optional.empty();
    private Optional<JoinTeam> wantedTeam = Optional.empty();
    private Optional<Beam> wantedBeam = Optional.empty();
    private Optional<Beam> lastBeam = Optional.empty();
    private @Nullable Participant lastParticipant;
    private boolean isNewborn;
    private boolean teamToBeTold;
    private long cycles;
    private long cyclesInTeam;

    AgentSession(AgentChannel connection) {
        this.connection = connection;
    }

    /** {@return its connection} */
    public AgentChannel connection() {
        return connection;
    }

    Hearing hearing() {
        return hearing;
    }

    /** {@return its robot; empty before it has one and after it lost it} */
    public Optional<Robot> robot() {
        return robot;
    }

    /** {@return its place in a team; empty before it joined one} */
    public Optional<Player> player() {
        return player;
    }

    Optional<Camera> camera() {
        return camera;
    }

    void setRobot(Robot newRobot) {
        robot = Optional.of(newRobot);
        isNewborn = true;
    }

    /** A robot with the number and the eyes that belong to it. */
    record Body(int id, Robot robot, Optional<Camera> camera) {

        RobotType type() {
            return robot.model().type();
        }
    }

    /** The agent's robot with everything that belongs to it. */
    Body body() {
        return new Body(id, robot.orElseThrow(), camera);
    }

    /** Exchanges the robot for another one, before the agent has joined a team. */
    void setBody(Body body) {
        id = body.id();
        robot = Optional.of(body.robot());
        camera = body.camera();
    }

    /** Whether the robot was created in this cycle; its perceptors start working in the next one. */
    boolean isNewborn() {
        return isNewborn;
    }

    /** Sets the agent's camera, which keeps its errors in each new body. */
    void setCamera(Camera newCamera) {
        camera = Optional.of(newCamera);
    }

    /** What the camera has seen in this cycle. */
    Optional<Vision> picture() {
        return picture;
    }

    void setPicture(Optional<Vision> newPicture) {
        picture = newPicture;
    }

    /** {@return the number of the agent's robot, which counts all robots of a run} */
    public int id() {
        return id;
    }

    void setId(int newId) {
        id = newId;
    }

    void join(Player newPlayer) {
        player = Optional.of(newPlayer);
        teamToBeTold = true;
        cyclesInTeam = 0;
    }

    /** Keeps number and team in a new body. */
    void replacePlayer(Player newPlayer) {
        player = Optional.of(newPlayer);
    }

    /** Leaves the agent without robot; as in the original it gets the last message again and again. */
    void loseRobot() {
        robot = Optional.empty();
        player = Optional.empty();
        lastParticipant = null;
    }

    void want(CreateRobot command) {
        wantedRobot = Optional.of(command);
    }

    void want(JoinTeam command) {
        wantedTeam = Optional.of(command);
    }

    void want(Beam command) {
        wantedBeam = Optional.of(command);
    }

    void remember(Beam beam) {
        lastBeam = Optional.of(beam);
    }

    /** Where the robot was beamed last, with noise. */
    Optional<Beam> lastBeam() {
        return lastBeam;
    }

    Optional<CreateRobot> wantedRobot() {
        return wantedRobot;
    }

    Optional<JoinTeam> wantedTeam() {
        return wantedTeam;
    }

    Optional<CreateRobot> takeWantedRobot() {
        Optional<CreateRobot> taken = wantedRobot;
        wantedRobot = Optional.empty();
        return taken;
    }

    Optional<JoinTeam> takeWantedTeam() {
        Optional<JoinTeam> taken = wantedTeam;
        wantedTeam = Optional.empty();
        return taken;
    }

    Optional<Beam> takeWantedBeam() {
        Optional<Beam> taken = wantedBeam;
        wantedBeam = Optional.empty();
        return taken;
    }

    /** Whether number and team are to be sent; true once after joining. */
    boolean takeTeamToBeTold() {
        boolean taken = teamToBeTold;
        teamToBeTold = false;
        return taken;
    }

    /** Counts a cycle; vision comes in every third one since the agent has connected. */
    void cycleBegins() {
        cycles++;
        cyclesInTeam++;
        isNewborn = false;
    }

    boolean seesInThisCycle() {
        return cycles % CameraSettings.CYCLES_PER_PICTURE == 0;
    }

    double secondsInTeam() {
        return cyclesInTeam * Cycle.SECONDS;
    }

    @Override
    public String toString() {
        return player.map(Player::toString).orElse("an agent without team") + " ("
                + connection.link().address() + ")";
    }

    /** {@return what the robot and the agent have said to each other in a cycle, the last one} */
    AgentMessages messages(long cycle) {
        return new AgentMessages(
                id(),
                cycle,
                connection.newestMessage().toString(),
                connection.executedMessage().toString());
    }

    /** Adds the agent with its robot to those that are recorded; nothing is added without robot. */
    void addParticipantTo(List<Participant> participants) {
        if (robot.isPresent()) {
            participants.add(participant(robot.get()));
        }
    }

    private Participant participant(Robot body) {
        Participant now = lastParticipant;
        if (now == null
                || now.id() != id
                || now.robot() != body
                || now.commands() != connection.executedCommands()
                || now.unansweredMessages() != connection.unansweredMessages()
                || !now.player().equals(player)) {
            now = new Participant(id, player, body, connection.executedCommands(), connection.unansweredMessages());
            lastParticipant = now;
        }
        return now;
    }

    /** {@return whether nobody is at the other end, so that the next state that is restored needs no such agent} */
    boolean isAbsent() {
        return connection.link() instanceof AbsentLink;
    }

    void save(StateWriter out, List<Robot> robots, List<Player> players) {
        connection.save(out);
        hearing.save(out);
        out.putInt(id);
        out.putOptional(robot, body -> out.putInt(robots.indexOf(body)));
        out.putOptional(player, member -> out.putInt(players.indexOf(member)));
        out.putOptional(camera, eye -> eye.save(out));
        out.putOptional(lastBeam, beam -> SavedCommand.save(beam, out));
        out.putBoolean(isNewborn);
        out.putBoolean(teamToBeTold);
        out.putLong(cycles);
        out.putLong(cyclesInTeam);
    }

    void restore(StateReader in, List<Robot> robots, List<Player> players, Supplier<Camera> newCamera) {
        connection.restore(in);
        hearing.restore(in);
        id = in.getInt();
        robot = in.getOptional(() -> robots.get(in.getIndex(robots.size())));
        player = in.getOptional(() -> players.get(in.getIndex(players.size())));
        Camera eye = camera.orElseGet(newCamera);
        camera = in.getOptional(() -> eye);
        camera.ifPresent(present -> present.restore(in));
        lastBeam = in.getOptional(() -> SavedCommand.restoreBeam(in));
        isNewborn = in.getBoolean();
        teamToBeTold = in.getBoolean();
        cycles = in.getLong();
        cyclesInTeam = in.getLong();
    }
}
