package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.ObjDoubleConsumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;
import org.robonewbie.protocol.effector.EffectorCommand.RequestPass;
import org.robonewbie.protocol.effector.EffectorCommand.Say;
import org.robonewbie.protocol.effector.EffectorCommand.SetHingeSpeed;
import org.robonewbie.simulator.sensing.Camera;
import org.robonewbie.simulator.sensing.CameraSettings;
import org.robonewbie.simulator.soccer.JoinRefusedException;
import org.robonewbie.simulator.soccer.Match;
import org.robonewbie.simulator.soccer.Player;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.state.JavaUtilRandom;
import org.robonewbie.simulator.state.SplittableRandomSource;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * Executes the commands of agents. Motor speeds and say messages take effect immediately; create, init and beam commands are
 * deferred until just before the next physics step.
 */
final class Effectors implements Restorable {

    private static final int MAX_ROBOTS = 44;
    private static final double SPACING_METRES = 1;
    private static final double HEARING_RANGE = 50;
    private static final Vector3 POSITION_OF_REFUSED = new Vector3(0, 0, 10);

    private final SoccerWorld world;
    private final Match match;
    private final CameraSettings cameraSettings;
    private final JavaUtilRandom random;
    private int createdRobots;

    Effectors(SoccerWorld world, Match match, CameraSettings cameraSettings, long seed) {
        this.world = world;
        this.match = match;
        this.cameraSettings = cameraSettings;
        this.random = new JavaUtilRandom(seed);
    }

    /** Executes immediate commands and stores the others for {@link #prepareStep}. */
    void execute(AgentSession agent, List<AgentSession> all) {
        for (EffectorCommand command : agent.connection().takeCommands()) {
            if (command instanceof CreateRobot create) {
                wantRobot(agent, create);
            } else if (agent.robot().isEmpty()) {
                agent.connection()
                        .warn(
                                "no robot",
                                "sent a command although it has no robot. Send (scene " + CreateRobot.SCENE
                                        + ") first and wait for a message.");
            } else {
                execute(agent, agent.robot().get(), command, all);
            }
        }
    }

    /** Executes the agent's deferred create, init and beam commands. */
    void prepareStep(AgentSession agent) {
        Optional<CreateRobot> body = agent.takeWantedRobot();
        if (body.isPresent()) {
            create(agent, body.get());
        }
        Optional<JoinTeam> team = agent.takeWantedTeam();
        if (team.isPresent()) {
            join(agent, team.get());
        }
        Optional<Beam> beam = agent.takeWantedBeam();
        if (beam.isPresent()) {
            beam(agent, beam.get());
        }
    }

    /** Replaces a player's body with a new one at its last beam pose, with all joints at 0. */
    void renew(AgentSession agent, Player player) {
        Robot robot = world.addRobot(player.robot().type());
        world.removeRobot(player.robot());
        agent.replacePlayer(match.replaceRobot(player, robot));
        agent.setRobot(robot);
        putToStart(agent);
    }

    /** Moves a robot to its last beam pose or, if there is none, to the start position of new robots. */
    private void putToStart(AgentSession agent) {
        agent.player()
                .ifPresent(player -> agent.lastBeam()
                        .ifPresentOrElse(
                                beam -> place(player, beam.pose(), player.robot()::moveUpright),
                                () -> match.teams().putToStart(player)));
    }

    private void execute(AgentSession agent, Robot robot, EffectorCommand command, List<AgentSession> all) {
        if (command instanceof SetHingeSpeed speed) {
            setSpeed(agent, robot, speed);
        } else if (command instanceof JoinTeam join) {
            agent.want(ownTeam(agent, join));
        } else if (command instanceof Beam beam) {
            agent.want(beam);
        } else if (command instanceof Say say) {
            agent.player().ifPresent(speaker -> say(agent, speaker, say.text(), all));
        } else if (command instanceof RequestPass) {
            agent.player().ifPresent(match::requestPass);
        }
    }

    private static JoinTeam ownTeam(AgentSession agent, JoinTeam join) {
        return agent.connection()
                .link()
                .team()
                .map(team -> new JoinTeam(join.number(), team))
                .orElse(join);
    }

    private static void wantRobot(AgentSession agent, CreateRobot create) {
        if (agent.robot().isEmpty()) {
            agent.want(create);
        } else {
            agent.connection().warn("second robot", "requested a second robot; it keeps the first one.");
        }
    }

    private void setSpeed(AgentSession agent, Robot robot, SetHingeSpeed command) {
        String name = command.effectorName();
        double speed = command.radiansPerSecond();
        OptionalInt hinge = robot.nao().hingeIndex(name);
        if (hinge.isEmpty()) {
            int type = robot.type().ordinal();
            agent.connection()
                    .warn(name, "moves hinge " + name + ", which a robot of type " + type + " does not have.");
            return;
        }
        if (Double.isNaN(speed)) {
            String problem = "sent speed NaN for hinge " + name + ", which is ignored. Was something divided by zero?";
            agent.connection().warn("NaN " + name, problem);
        }
        robot.setMotorSpeed(hinge.getAsInt(), isFrozen(agent, hinge.getAsInt()) ? 0 : speed);
    }

    private boolean isFrozen(AgentSession agent, int hinge) {
        return agent.player().isPresent() && match.isFrozen(agent.player().get(), hinge);
    }

    private static void say(AgentSession agent, Player speaker, String text, List<AgentSession> all) {
        String team = speaker.team().name();
        agent.hearing().hearOwn(team, text);
        for (AgentSession other : all) {
            if (other != agent && other.player().isPresent()) {
                Player listener = other.player().get();
                Vector3 offset = speaker.position().minus(listener.position());
                if (offset.length() <= HEARING_RANGE) {
                    double sign = listener.side() == TeamSide.LEFT ? 1 : -1;
                    double direction = Angles.atan2(sign * offset.y(), sign * offset.x());
                    other.hearing().hear(listener.team() == speaker.team(), team, direction, text);
                }
            }
        }
    }

    private void create(AgentSession agent, CreateRobot create) {
        int type = robotType(create);
        if (type < 0) {
            agent.connection()
                    .warn(
                            "scene",
                            "requested the unknown robot \"" + create.path() + " "
                                    + String.join(" ", create.parameters()) + "\". Use " + CreateRobot.SCENE
                                    + " or "
                                    + CreateRobot.SCENE_OF_TYPE + " with a type from 0 to 4.");
        } else if (world.robots().size() >= MAX_ROBOTS) {
            agent.connection().warn("crowd", "gets no robot because there are already " + MAX_ROBOTS + " robots.");
        } else {
            Vector3 position = freePosition(Robot.START_POSITION);
            Robot robot = world.addRobot(RobotType.values()[type]);
            robot.moveTo(position);
            agent.setId(nextId());
            agent.setRobot(robot);
            agent.setCamera(newCamera(random.nextLong()));
        }
    }

    /** Returns a free position near the desired one; interpenetrating robots would slow down the physics. */
    private Vector3 freePosition(Vector3 wanted) {
        Vector3 position = wanted;
        for (int i = 1; isOccupied(position); i++) {
            int column = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
            position = wanted.plus(new Vector3(column * SPACING_METRES, 0, 0));
        }
        return position;
    }

    private boolean isOccupied(Vector3 position) {
        return world.robots().stream()
                .map(robot -> robot.torso().position())
                .anyMatch(other ->
                        PortableMath.hypot(other.x() - position.x(), other.y() - position.y()) < SPACING_METRES - 0.01);
    }

    /** Returns the requested robot type; -1 if it does not exist. */
    private static int robotType(CreateRobot create) {
        if (create.path().equals(CreateRobot.SCENE)) {
            return 0;
        }
        if (!create.path().equals(CreateRobot.SCENE_OF_TYPE)) {
            return -1;
        }
        String type = create.parameters().isEmpty() ? "0" : create.parameters().get(0);
        return type.matches("[0-4]") ? type.charAt(0) - '0' : -1;
    }

    private void join(AgentSession agent, JoinTeam join) {
        if (agent.player().isPresent()) {
            agent.connection()
                    .warn(
                            "init",
                            "tried to join a team again; it remains "
                                    + agent.player().get() + ".");
            match.teams().putToStart(agent.player().get());
            return;
        }
        Robot robot = agent.robot().orElseThrow();
        try {
            agent.join(match.teams().join(join.team(), join.number(), robot));
        } catch (JoinRefusedException e) {
            agent.connection().warn(String.valueOf(e.getMessage()), "cannot join: " + e.getMessage() + ".");
            robot.moveUpright(freePosition(POSITION_OF_REFUSED), 0);
        }
    }

    private void beam(AgentSession agent, Beam beam) {
        if (agent.player().isEmpty() || !mayBeam(agent)) {
            return;
        }
        SoccerParameters parameters = match.parameters();
        double noise = parameters.get(SoccerParameter.BEAM_NOISE_XY);
        Pose2d pose = new Pose2d(
                beam.pose().x() + spread(noise),
                beam.pose().y() + spread(noise),
                beam.pose().degrees() + spread(parameters.get(SoccerParameter.BEAM_NOISE_ANGLE)));
        if (!Double.isFinite(pose.x()) || !Double.isFinite(pose.y()) || !Double.isFinite(pose.degrees())) {
            agent.connection().warn("beam", "requested a beam to " + beam.pose() + ", which is not a finite pose.");
            return;
        }
        agent.remember(new Beam(pose));
        Player player = agent.player().get();
        place(player, pose, player.robot()::beam);
    }

    private void place(Player player, Pose2d wanted, ObjDoubleConsumer<Vector3> move) {
        SoccerField field = world.field();
        double x = wanted.x();
        double y = wanted.y();
        if (!match.parameters().isOn(SoccerParameter.START_ANY_FIELD_POSITION)) {
            x = Math.max(-field.length() / 2, Math.min(0, x));
            y = Math.max(-field.width() / 2, Math.min(field.width() / 2, y));
        }
        double z = match.parameters().get(SoccerParameter.AGENT_RADIUS);
        boolean left = player.side() == TeamSide.LEFT;
        Vector3 position = left ? new Vector3(x, y, z) : new Vector3(-x, -y, z);
        move.accept(position, wanted.degrees() + (left ? -90 : 90));
    }

    private boolean mayBeam(AgentSession agent) {
        return match.mayBeam() || agent.secondsInTeam() < match.parameters().get(SoccerParameter.BEAM_GRACE_TIME);
    }

    private double spread(double limit) {
        return limit == 0 ? 0 : limit * (2 * random.nextDouble() - 1);
    }

    Camera newCamera(long seed) {
        return new Camera(world.field(), cameraSettings, new SplittableRandomSource(seed));
    }

    @Override
    public void save(StateWriter out) {
        random.save(out);
        out.putInt(createdRobots);
    }

    @Override
    public void restore(StateReader in) {
        random.restore(in);
        createdRobots = in.getInt();
    }

    int createdRobots() {
        return createdRobots;
    }

    void setCreatedRobots(int robots) {
        createdRobots = robots;
    }

    int nextId() {
        return ++createdRobots;
    }
}
