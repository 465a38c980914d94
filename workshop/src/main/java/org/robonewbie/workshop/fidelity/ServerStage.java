package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.SteppedServer;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/** Full server with league rules but no noise. The robot is controlled and observed only through agent messages. */
final class ServerStage implements ReplayStage {

    private static final int FIRST_MESSAGE = 3;
    private static final String TEAM = "Recorded";

    private final SteppedServer server;
    private final AgentLink agent;
    private final MessageBuffer message = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    private ServerStage(SteppedServer server, AgentLink agent) {
        this.server = server;
        this.agent = agent;
    }

    static ServerStage open(AgentRoute route, RobotType type, JoiningWay way) throws IOException {
        SteppedServer server = SteppedServer.start(settings(), Console.silent());
        try {
            leavePlacesBefore(way, server);
            AgentLink agent = route == AgentRoute.TCP
                    ? server.connect()
                    : server.simulator().connect();
            ServerStage stage = new ServerStage(server, agent);
            stage.join(type, way.cyclesToInit());
            return stage;
        } catch (IOException e) {
            server.close();
            throw e;
        }
    }

    /** {@return settings without any randomness} */
    static WorldSettings settings() {
        return WorldSettings.league()
                .withParameters(SoccerParameters.league()
                        .with("BeamNoiseXY=0")
                        .with("BeamNoiseAngle=0")
                        .with("StartAnyFieldPosition=true"))
                .withNoise(false);
    }

    @Override
    public Robot robot() {
        return server.simulator().world().robots().get(0);
    }

    @Override
    public void placeBall(Vector3 position) {
        server.simulator().match().setPlayMode(PlayMode.PLAY_ON);
        server.simulator().world().ball().place(position);
    }

    @Override
    public Ball ball() {
        return server.simulator().world().ball();
    }

    @Override
    public Measurements step(List<EffectorCommand> commands) throws IOException {
        message.clear();
        EffectorMessageWriter writer = new EffectorMessageWriter(message);
        commands.forEach(writer::write);
        writer.synchronise();
        agent.send(message);
        server.cycle();
        return Measurements.of(receive());
    }

    @Override
    public void close() {
        agent.close();
        server.close();
    }

    /**
     * Lets other robots join and leave first, so that the robot gets the right start position and side: a server never reuses
     * a start position, and its first team plays on the left.
     */
    private static void leavePlacesBefore(JoiningWay way, SteppedServer server) throws IOException {
        if (way.side() == TeamSide.RIGHT) {
            visit(server, "Visitors");
        }
        for (int visitor = 0; visitor < way.placesBefore(); visitor++) {
            visit(server, TEAM);
        }
    }

    private static void visit(SteppedServer server, String team) throws IOException {
        try (AgentLink visitor = server.simulator().connect()) {
            MessageBuffer message = new MessageBuffer();
            new EffectorMessageWriter(message).write(CreateRobot.of(0)).synchronise();
            visitor.send(message);
            server.cycle();
            message.clear();
            new EffectorMessageWriter(message).joinTeam(0, team).synchronise();
            visitor.send(message);
            server.cycle();
        }
        server.cycle();
    }

    /** Creates the robot. It appears in the first cycle; its first message follows after the third. */
    private void join(RobotType type, int cyclesToInit) throws IOException {
        message.clear();
        new EffectorMessageWriter(message)
                .createRobot(CreateRobot.SCENE_OF_TYPE, List.of(String.valueOf(type.ordinal())))
                .synchronise();
        agent.send(message);
        for (int cycle = 1; cycle <= cyclesToInit; cycle++) {
            server.cycle();
            if (cycle >= FIRST_MESSAGE) {
                receive();
            }
        }
        step(List.of(new EffectorCommand.JoinTeam(1, TEAM)));
    }

    private PerceptorMessage receive() throws IOException {
        if (!agent.receive(message)) {
            throw new IOException("The server closed the agent's connection.");
        }
        return reader.read(message);
    }
}
