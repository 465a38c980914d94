package org.robonewbie.workshop.speed;

import java.io.EOFException;
import java.io.IOException;
import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.GameState;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** An agent as plain as can be: it reads its message and turns every joint towards the scene's target. */
final class BenchmarkAgent {

    private static final int MESSAGES_BEFORE_JOINING = 2;
    private static final double GAIN_PER_SECOND = 12;

    private final AgentLink link;
    private final int robot;
    private final MessageBuffer message = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();
    private int messages;
    private boolean inTeam;

    BenchmarkAgent(AgentLink link, int robot) {
        this.link = link;
        this.robot = robot;
    }

    static String team(int robot) {
        return robot % 2 == 0 ? "Reds" : "Blues";
    }

    static int number(int robot) {
        return 1 + robot / 2;
    }

    /** Asks for a body. */
    void create() throws IOException {
        message.clear();
        new EffectorMessageWriter(message).write(CreateRobot.of(0)).synchronise();
        link.send(message);
    }

    /** Waits for a message and answers it, the second one by joining its team. */
    void join() throws IOException {
        inTeam |= receive().gameState().flatMap(GameState::side).isPresent();
        messages++;
        message.clear();
        EffectorMessageWriter writer = new EffectorMessageWriter(message);
        if (messages == MESSAGES_BEFORE_JOINING) {
            writer.joinTeam(number(robot), team(robot));
        }
        writer.synchronise();
        link.send(message);
    }

    /** Whether the server has said in which team the robot is. */
    boolean isInTeam() {
        return inTeam;
    }

    /** How many messages it has answered before it plays. */
    int messages() {
        return messages;
    }

    boolean isMessageWaiting() throws IOException {
        return link.isMessageWaiting();
    }

    /** Takes part in a cycle: waits for the message, thinks, answers. */
    void act(CrowdScene scene, int cycle) throws IOException {
        PerceptorMessage percepts = receive();
        message.clear();
        EffectorMessageWriter writer = new EffectorMessageWriter(message);
        for (Joint joint : Joint.values()) {
            double missing = scene.targetDegrees(joint, robot, cycle)
                    - percepts.jointAngles().degreesOr(joint, 0);
            writer.hingeSpeed(joint.effectorName(), Math.toRadians(GAIN_PER_SECOND * missing));
        }
        writer.synchronise();
        link.send(message);
    }

    void leave() {
        link.close();
    }

    private PerceptorMessage receive() throws IOException {
        if (!link.receive(message)) {
            throw new EOFException("The server has closed the connection of robot " + (robot + 1)
                    + ". Is there room for it in the team " + team(robot) + "?");
        }
        return reader.read(message);
    }
}
