package org.robonewbie.simulator.fidelity;

import java.io.IOException;
import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.server.Console;
import org.robonewbie.simulator.server.SimulatorSettings;
import org.robonewbie.simulator.server.SteppedSimulator;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.PhysicsEngine;
import org.robonewbie.simulator.world.Robot;

/** A whole server with league rules and without noise; the robot is moved, and felt, by an agent's messages only. */
final class ServerStage implements Stage {

    private static final int FIRST_MESSAGE = 3;
    private static final String TEAM = "Recorded";

    private final SteppedSimulator simulator;
    private final AgentLink agent;
    private final MessageBuffer message = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    private ServerStage(SteppedSimulator simulator, AgentLink agent) {
        this.simulator = simulator;
        this.agent = agent;
    }

    static ServerStage open(AgentRoute route, RobotType type, PhysicsEngine physics, JoiningWay way)
            throws IOException {
        SteppedSimulator simulator = SteppedSimulator.start(settings(physics), Console.silent());
        try {
            leavePlacesBefore(way, simulator);
            AgentLink agent = route == AgentRoute.TCP ? simulator.connectOverTcp() : simulator.connect();
            ServerStage stage = new ServerStage(simulator, agent);
            stage.join(type, way.cyclesToInit());
            return stage;
        } catch (IOException e) {
            simulator.close();
            throw e;
        }
    }

    /** Settings of a server that does nothing by chance. */
    static SimulatorSettings settings(PhysicsEngine physics) {
        return SimulatorSettings.league()
                .parameters(SoccerParameters.league()
                        .with("BeamNoiseXY=0")
                        .with("BeamNoiseAngle=0")
                        .with("StartAnyFieldPosition=true"))
                .agentPort(0)
                .synchronous(true)
                .noise(false)
                .physics(physics)
                .build();
    }

    @Override
    public Robot robot() {
        return simulator.world().robots().get(0);
    }

    @Override
    public void placeBall(Vector3 position) {
        simulator.match().setPlayMode(PlayMode.PLAY_ON);
        simulator.world().ball().place(position);
    }

    @Override
    public Ball ball() {
        return simulator.world().ball();
    }

    @Override
    public Measurements step(List<EffectorCommand> commands) throws IOException {
        message.clear();
        EffectorMessageWriter writer = new EffectorMessageWriter(message);
        commands.forEach(writer::write);
        writer.synchronise();
        agent.send(message);
        simulator.cycle();
        return Measurements.of(receive());
    }

    @Override
    public void close() {
        agent.close();
        simulator.close();
    }

    /** Other robots join and leave, since a server never gives a place of the row twice, and the first team is the left one. */
    private static void leavePlacesBefore(JoiningWay way, SteppedSimulator simulator) throws IOException {
        if (way.side() == TeamSide.RIGHT) {
            visit(simulator, "Visitors");
        }
        for (int visitor = 0; visitor < way.placesBefore(); visitor++) {
            visit(simulator, TEAM);
        }
    }

    private static void visit(SteppedSimulator simulator, String team) throws IOException {
        try (AgentLink visitor = simulator.connect()) {
            MessageBuffer message = new MessageBuffer();
            new EffectorMessageWriter(message)
                    .createRobot("rsg/agent/nao/nao.rsg", List.of())
                    .synchronise();
            visitor.send(message);
            simulator.cycle();
            message.clear();
            new EffectorMessageWriter(message).joinTeam(0, team).synchronise();
            visitor.send(message);
            simulator.cycle();
        }
        simulator.cycle();
    }

    /** The robot appears in the first cycle; its first message comes after the third one. */
    private void join(RobotType type, int cyclesToInit) throws IOException {
        message.clear();
        new EffectorMessageWriter(message)
                .createRobot("rsg/agent/nao/nao_hetero.rsg", List.of(String.valueOf(type.ordinal())))
                .synchronise();
        agent.send(message);
        for (int cycle = 1; cycle <= cyclesToInit; cycle++) {
            simulator.cycle();
            if (cycle >= FIRST_MESSAGE) {
                receive();
            }
        }
        step(List.of(new EffectorCommand.JoinTeam(1, TEAM)));
    }

    private PerceptorMessage receive() throws IOException {
        if (!agent.receive(message)) {
            throw new IOException("The server has closed the connection of the agent.");
        }
        return reader.read(message);
    }
}
