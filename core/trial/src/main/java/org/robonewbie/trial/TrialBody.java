package org.robonewbie.trial;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.world.Robot;

/** A robot of a trial with its connection to the simulator, its body in the world and its controller. */
final class TrialBody {

    private final AgentLink link;
    private final RobotStart start;
    private final MessageBuffer received = new MessageBuffer();
    private final MessageBuffer answer = new MessageBuffer();
    private final EffectorMessageWriter writer = new EffectorMessageWriter(answer);
    private final Robot robot;
    private Controller controller;
    private SensorReadings readings = new TextReadings(received);
    private List<EffectorCommand> commands = List.of();
    private boolean mayBeam;

    TrialBody(AgentLink link, RobotStart start, Robot robot, Controller controller) {
        this.link = link;
        this.start = start;
        this.robot = robot;
        this.controller = controller;
        receive();
    }

    /** Sends the command that creates a robot. */
    static void create(AgentLink link, RobotType type) {
        MessageBuffer message = new MessageBuffer();
        new EffectorMessageWriter(message).write(CreateRobot.of(type.ordinal())).synchronise();
        send(link, message);
    }

    RobotStart start() {
        return start;
    }

    Robot robot() {
        return robot;
    }

    Controller controller() {
        return controller;
    }

    void setController(Controller other) {
        controller = other;
    }

    SensorReadings readings() {
        return readings;
    }

    void setReadings(SensorReadings newReadings) {
        readings = newReadings;
    }

    /** Returns the controller's commands for this cycle. */
    List<EffectorCommand> commands() {
        return commands;
    }

    void allowBeams() {
        mayBeam = true;
    }

    /** Gets the controller's commands for the current readings. Removes beam commands unless the trial allows them. */
    void perform() {
        commands = controller.respond(readings).stream()
                .filter(command -> !(command instanceof EffectorCommand.Synchronise))
                .filter(command -> mayBeam || !(command instanceof EffectorCommand.Beam))
                .toList();
    }

    void idle() {
        commands = List.of();
    }

    void join() {
        writer.joinTeam(start.number(), start.team());
    }

    /** Sends the commands for this cycle to the simulator. */
    void send() {
        commands.forEach(writer::write);
        writer.synchronise();
        send(link, answer);
        answer.clear();
    }

    void receive() {
        try {
            if (!link.receive(received)) {
                throw new IllegalStateException("The simulator has disconnected a robot of the trial.");
            }
            readings = new TextReadings(received);
        } catch (IOException broken) {
            throw unanswered(broken);
        }
    }

    void close() {
        link.close();
        controller.close();
    }

    private static void send(AgentLink link, MessageBuffer message) {
        try {
            link.send(message);
        } catch (IOException broken) {
            throw unanswered(broken);
        }
    }

    static UncheckedIOException unanswered(IOException broken) {
        return new UncheckedIOException("The simulator of the trial does not answer.", broken);
    }
}
