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

/** Minimal agent: parses its message and turns every joint towards the target angle of the scene. */
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

    /** Requests a robot from the server. */
    void create() throws IOException {
        message.clear();
        new EffectorMessageWriter(message).write(CreateRobot.of(0)).synchronise();
        link.send(message);
    }

    /** Waits for a message and replies to it; the second reply joins the team. */
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

    /** Returns whether the server has assigned the robot to a team. */
    boolean isInTeam() {
        return inTeam;
    }

    /** Returns the number of messages handled before the start of the game. */
    int messages() {
        return messages;
    }

    boolean isMessageWaiting() throws IOException {
        return link.isMessageWaiting();
    }

    /** Waits for the message of a cycle and replies to it. */
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
            throw new EOFException("The server closed the connection to robot " + (robot + 1) + ". Check that team "
                    + team(robot) + " has a free place.");
        }
        return reader.read(message);
    }
}
