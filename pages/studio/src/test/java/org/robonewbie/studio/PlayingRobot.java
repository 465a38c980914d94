package org.robonewbie.studio;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** The real simulator in real time with a robot that nods, raises an arm too fast and shouts; its program runs in this process. */
final class PlayingRobot implements AutoCloseable {

    private final Simulator simulator;

    private PlayingRobot(Simulator simulator) {
        this.simulator = simulator;
    }

    /** Starts it with an optional monitor port. */
    static PlayingRobot start(OptionalInt monitorPort) throws IOException {
        SimulatorSettings settings = SimulatorSettings.of(WorldSettings.beginner())
                .withAgentPort(0)
                .withMonitors(new SimulatorSettings.Monitors(monitorPort, 0.04, true, Optional.empty()));
        PlayingRobot robot = new PlayingRobot(Simulator.start(settings, Console.silent()));
        start(robot.simulator.connect());
        return robot;
    }

    /** Starts its program only, in another simulator. */
    static void start(AgentLink link) {
        Thread program = new Thread(() -> play(link), "playing-robot");
        program.setDaemon(true);
        program.start();
    }

    Simulator simulator() {
        return simulator;
    }

    private static void play(AgentLink link) {
        try (link) {
            say(link, "(scene rsg/agent/nao/nao.rsg)(syn)");
            MessageBuffer percepts = new MessageBuffer();
            for (int cycle = 0; link.receive(percepts); cycle++) {
                String nod = "(he2 " + (cycle % 100 < 50 ? 0.5 : -0.5) + ")(lae1 9.5)(say step" + cycle + ")";
                String start = cycle == 0 ? "(init (unum 1)(teamname Stars))" : cycle == 3 ? "(beam -2 0 0)" : nod;
                say(link, start + "(syn)");
            }
        } catch (IOException simulatorHasEnded) {
            // The simulator has ended.
        }
    }

    private static void say(AgentLink link, String text) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(text);
        link.send(message);
    }

    @Override
    public void close() {
        simulator.close();
    }
}
