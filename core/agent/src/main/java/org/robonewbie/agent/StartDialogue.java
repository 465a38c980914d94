package org.robonewbie.agent;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.cycle.MessagePort;
import org.robonewbie.agent.cycle.RobotRuntime;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorCommand.Beam;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorCommand.JoinTeam;
import org.robonewbie.protocol.effector.EffectorCommand.Synchronise;

/**
 * Start-up dialogue of a robot: creates the robot, joins a team, waits for its player number and side, beams to the
 * starting pose and stands there. Each message is answered exactly once, so the dialogue works with servers in lockstep
 * and in real time.
 */
final class StartDialogue {

    private static final String MONITOR_START = "((";
    private static final String LEAGUE_MONITOR_START = "((RSMP ";
    private static final String LEAGUE_ADVICE = "RCSSServerMJ, the server of today's league, which does not speak"
            + " SimSpark's protocol: start \"robonewbie simulator\" instead, or play there through"
            + " \"python -m robonewbie.league bridge\".";
    private static final String LEAGUE_AGENT_PORT =
            "RCSSServerMJ, which is for watching: join at its agent port, which is usually 60000 (--port 60000).";
    private static final int MAX_MESSAGES = 100;

    private final MessagePort port;
    private final RobotRuntime robot;
    private final Options options;

    StartDialogue(MessagePort port, RobotRuntime robot, Options options) {
        this.port = port;
        this.robot = robot;
        this.options = options;
    }

    /**
     * Runs the dialogue.
     *
     * @param atFirstMessage called when the simulator has sent its first message
     * @param inPlace called when the robot has responded to the first message after beaming to its starting pose
     */
    void run(Runnable atFirstMessage, Runnable inPlace) throws IOException {
        robot.sensors().setTeam(options.team());
        robot.sensors().setType(options.robotType());
        answer(Optional.of(CreateRobot.of(options.type())));
        if (!port.receive()) {
            throw new IOException(
                    "it closed the connection at the first message. Either it has too many agents, or it is "
                            + LEAGUE_ADVICE);
        }
        refuseMonitorPort();
        robot.sense(port.message());
        atFirstMessage.run();
        answer(Optional.of(new JoinTeam(options.number(), options.team())));
        waitForNumber();
        answer(Optional.of(new Beam(options.pose(robot.sensors().number()))));
        for (int i = 0; i < port.messagesToSettle(); i++) {
            receive();
            answer(Optional.empty());
            if (i == 0) {
                inPlace.run();
            }
        }
        robot.sensors().falls().reset();
    }

    /** Monitor messages start with a list of lists; messages to agents start with a named list. */
    private void refuseMonitorPort() throws IOException {
        if (robot.sensors().buffer().startsWith(LEAGUE_MONITOR_START)) {
            throw new IOException("this is the monitor port of "
                    + (options.leagueRobot().isPresent() ? LEAGUE_AGENT_PORT : LEAGUE_ADVICE));
        } else if (robot.sensors().buffer().startsWith(MONITOR_START)) {
            throw new IOException(
                    "this is the monitor port of a SimSpark server, which is for watching: join at its agent port,"
                            + " which is usually 3100 (--port 3100).");
        }
    }

    private void waitForNumber() throws IOException {
        for (int i = 0; i < MAX_MESSAGES; i++) {
            receive();
            if (robot.sensors().isJoined()) {
                return;
            }
            answer(Optional.empty());
        }
        throw new StartUpException("The simulator refused number " + options.number() + " of team "
                + options.team() + ". Choose a free number (--number 0 takes any), or a team that is already"
                + " playing (--team). A league team has at most 7 robots of one type: choose another type (--type)"
                + " for the others.");
    }

    private void receive() throws IOException {
        if (!port.receive()) {
            throw new IOException("it closed the connection");
        }
        robot.sense(port.message());
    }

    private void answer(Optional<EffectorCommand> command) throws IOException {
        Synchronise end = new Synchronise();
        port.send(command.isPresent() ? List.of(command.get(), end) : List.of(end));
    }
}
