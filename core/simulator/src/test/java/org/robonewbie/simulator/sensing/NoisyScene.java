package org.robonewbie.simulator.sensing;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** Our server with all noise of the league and four robots like those of the recording with two teams, over TCP. */
final class NoisyScene {

    /** Team of the robot whose messages are read. */
    static final String TEAM = "Alpha";

    private static final int CYCLES_TO_REST = 150;
    private static final int CYCLES = 900;
    private static final int BEAMS = 120;

    private NoisyScene() {}

    /** Gives all messages to the first robot at rest. */
    static List<PerceptorMessage> messages() throws IOException {
        try (SteppedSimulator simulator = start()) {
            List<Client> clients = clients(simulator);
            List<PerceptorMessage> messages = new ArrayList<>();
            all(simulator, clients, "(syn)", CYCLES_TO_REST);
            for (int i = 0; i < CYCLES; i++) {
                messages.add(all(simulator, clients, "(say hallo)(syn)", 1));
            }
            return messages;
        }
    }

    /** Beams robots again and again; gives how far from the wanted x, y (metres) and heading (degrees) each one came down. */
    static List<double[]> beamErrors() throws IOException {
        try (SteppedSimulator simulator = start()) {
            List<Client> clients = clients(simulator);
            List<double[]> errors = new ArrayList<>();
            for (int i = 0; i < BEAMS; i++) {
                for (Client client : clients) {
                    client.send("(beam -5 " + client.lane + " 30)(syn)");
                }
                simulator.cycle();
                for (Client client : clients) {
                    client.receive();
                    boolean left = client.lane > 0;
                    BodyPose torso =
                            simulator.world().robots().get(client.index).torso();
                    double sign = left ? 1 : -1;
                    double heading = Math.toDegrees(Math.atan2(
                            torso.rotation().axisY().y(),
                            torso.rotation().axisY().x()));
                    errors.add(new double[] {
                        sign * torso.position().x() + 5,
                        sign * torso.position().y() - client.lane,
                        Angles.wrap(heading - 30 - (left ? 0 : 180))
                    });
                }
            }
            return errors;
        }
    }

    /** Tells where a part of the body is in the frame of the head of a robot with all joints at 0. */
    static Vector3 fromHead(BodyPart part) {
        Robot robot = new SoccerWorld(SoccerField.LEAGUE).addRobot(RobotType.TYPE_0);
        BodyPose head = robot.linkPose(robot.nao().linkIndex(BodyPart.HEAD.simSparkName()));
        Vector3 position =
                robot.linkPose(robot.nao().linkIndex(part.simSparkName())).position();
        return head.rotation().inverse().apply(position.minus(head.position()));
    }

    private static SteppedSimulator start() {
        return SteppedSimulator.start(WorldSettings.league().withSeed(20), Console.silent());
    }

    private static List<Client> clients(SteppedSimulator simulator) throws IOException {
        List<Client> clients = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            Client client = new Client(simulator.connect(), i, i < 2 ? 2 + 2 * i : -2 * i);
            client.send("(scene rsg/agent/nao/nao.rsg)(syn)");
            clients.add(client);
        }
        simulator.cycle();
        simulator.cycle();
        simulator.cycle();
        for (Client client : clients) {
            client.receive();
            String team = client.index < 2 ? TEAM : "Beta";
            client.send("(init (unum " + (client.index % 2 + 1) + ")(teamname " + team + "))(syn)");
        }
        simulator.cycle();
        for (Client client : clients) {
            client.receive();
        }
        String[] places = {"-3 0 0", "-1.5 1 180", "-2 0 0", "-4 -1 0"};
        for (Client client : clients) {
            client.send("(beam " + places[client.index] + ")(syn)");
        }
        simulator.cycle();
        for (Client client : clients) {
            client.receive();
        }
        return clients;
    }

    private static PerceptorMessage all(SteppedSimulator simulator, List<Client> clients, String text, int cycles)
            throws IOException {
        PerceptorMessage last = clients.get(0).newest;
        for (int i = 0; i < cycles; i++) {
            for (Client client : clients) {
                client.send(text);
            }
            simulator.cycle();
            for (Client client : clients) {
                client.receive();
            }
            last = clients.get(0).newest;
        }
        return last;
    }

    private static final class Client {

        private final AgentLink link;
        private final int index;
        private final double lane;
        private final MessageBuffer message = new MessageBuffer();
        private final PerceptorMessageReader reader = new PerceptorMessageReader();
        private PerceptorMessage newest = new PerceptorMessageReader().read(new MessageBuffer());

        Client(AgentLink link, int index, double lane) {
            this.link = link;
            this.index = index;
            this.lane = lane;
        }

        void send(String text) throws IOException {
            message.clear();
            message.append(text);
            link.send(message);
        }

        void receive() throws IOException {
            if (!link.receive(message)) {
                throw new IOException("The simulator has ended.");
            }
            newest = reader.read(message);
        }
    }
}
