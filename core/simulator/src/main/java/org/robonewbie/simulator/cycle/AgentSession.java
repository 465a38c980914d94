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

/** A connected agent with its robot and its requests in this cycle. */
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
    private boolean teamAnnouncementDue;
    private long cycles;
    private long cyclesInTeam;

    AgentSession(AgentChannel connection) {
        this.connection = connection;
    }

    /** {@return the message exchange with the agent} */
    public AgentChannel connection() {
        return connection;
    }

    Hearing hearing() {
        return hearing;
    }

    /** {@return the agent's robot; empty before the robot is created and after it is removed} */
    public Optional<Robot> robot() {
        return robot;
    }

    /** {@return the player that the agent controls; empty before it joins a team} */
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

    /** A robot with its id and camera. */
    record Body(int id, Robot robot, Optional<Camera> camera) {

        RobotType type() {
            return robot.type();
        }
    }

    Body body() {
        return new Body(id, robot.orElseThrow(), camera);
    }

    /** Replaces the robot. Call only before the agent has joined a team. */
    void setBody(Body body) {
        id = body.id();
        robot = Optional.of(body.robot());
        camera = body.camera();
    }

    /** Returns whether the robot was created in this cycle; its perceptors start in the next one. */
    boolean isNewborn() {
        return isNewborn;
    }

    /** Sets the camera, which keeps its calibration errors when the robot gets a new body. */
    void setCamera(Camera newCamera) {
        camera = Optional.of(newCamera);
    }

    /** Returns the camera image of this cycle. */
    Optional<Vision> picture() {
        return picture;
    }

    void setPicture(Optional<Vision> newPicture) {
        picture = newPicture;
    }

    /** {@return the id of the agent's robot, unique within a run} */
    public int id() {
        return id;
    }

    void setId(int newId) {
        id = newId;
    }

    void join(Player newPlayer) {
        player = Optional.of(newPlayer);
        teamAnnouncementDue = true;
        cyclesInTeam = 0;
    }

    /** Replaces the player with one that has a new body but the same team and number. */
    void replacePlayer(Player newPlayer) {
        player = Optional.of(newPlayer);
    }

    /** Removes the robot. As in rcssserver3d, the agent then keeps receiving the last message. */
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

    /** Returns the last beam pose, including noise. */
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

    /**
     * Returns whether the next message must contain the uniform number and the team; true only for the first call after
     * joining.
     */
    boolean takeTeamAnnouncement() {
        boolean taken = teamAnnouncementDue;
        teamAnnouncementDue = false;
        return taken;
    }

    void beginCycle() {
        cycles++;
        cyclesInTeam++;
        isNewborn = false;
    }

    /** Returns whether a camera image is due; one is taken in every third cycle after the agent connected. */
    boolean seesInThisCycle() {
        return cycles % CameraSettings.CYCLES_PER_PICTURE == 0;
    }

    double secondsInTeam() {
        return cyclesInTeam * Cycle.SECONDS;
    }

    @Override
    public String toString() {
        return player.map(Player::toString).orElse("an agent without a team") + " ("
                + connection.link().address() + ")";
    }

    /** Returns the messages that were exchanged in the given cycle, which must be the latest. */
    AgentMessages messages(long cycle) {
        return new AgentMessages(
                id(),
                cycle,
                connection.newestMessage().toString(),
                connection.executedMessage().toString());
    }

    /** Adds the agent to the recorded participants if it has a robot. */
    void addParticipantTo(List<Participant> participants) {
        if (robot.isPresent()) {
            participants.add(participant(robot.get()));
        }
    }

    private Participant participant(Robot body) {
        Participant current = lastParticipant;
        if (current == null
                || current.id() != id
                || current.robot() != body
                || current.commands() != connection.executedCommands()
                || current.unansweredMessages() != connection.unansweredMessages()
                || !current.player().equals(player)) {
            current = new Participant(id, player, body, connection.executedCommands(), connection.unansweredMessages());
            lastParticipant = current;
        }
        return current;
    }

    /** Returns whether this is the placeholder of an agent that was not connected when a state was restored. */
    boolean isAbsent() {
        return connection.link() instanceof AbsentLink;
    }

    void save(StateWriter out, List<Robot> robots, List<Player> players) {
        connection.save(out);
        hearing.save(out);
        out.putInt(id);
        out.putOptional(robot, body -> out.putInt(robots.indexOf(body)));
        out.putOptional(player, member -> out.putInt(players.indexOf(member)));
        out.putOptional(camera, present -> present.save(out));
        out.putOptional(lastBeam, beam -> SavedCommand.save(beam, out));
        out.putBoolean(isNewborn);
        out.putBoolean(teamAnnouncementDue);
        out.putLong(cycles);
        out.putLong(cyclesInTeam);
    }

    void restore(StateReader in, List<Robot> robots, List<Player> players, Supplier<Camera> newCamera) {
        connection.restore(in);
        hearing.restore(in);
        id = in.getInt();
        robot = in.getOptional(() -> robots.get(in.getIndex(robots.size())));
        player = in.getOptional(() -> players.get(in.getIndex(players.size())));
        Camera restored = camera.orElseGet(newCamera);
        camera = in.getOptional(() -> restored);
        camera.ifPresent(present -> present.restore(in));
        lastBeam = in.getOptional(() -> SavedCommand.restoreBeam(in));
        isNewborn = in.getBoolean();
        teamAnnouncementDue = in.getBoolean();
        cycles = in.getLong();
        cyclesInTeam = in.getLong();
    }
}
