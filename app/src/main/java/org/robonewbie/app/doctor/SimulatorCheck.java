package org.robonewbie.app.doctor;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robonewbie.protocol.effector.EffectorCommand.CreateRobot;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** Simulates a standing robot for one second and checks that it is still standing. */
final class SimulatorCheck {

    private static final int CYCLES = 50;
    private static final double MIN_TORSO_HEIGHT = 0.3;
    private static final String SUBJECT = "Simulator";

    private SimulatorCheck() {}

    static Finding oneSecond() {
        long start = System.nanoTime();
        try {
            double height = torsoHeightAfterOneSecond();
            double seconds = (System.nanoTime() - start) / 1e9;
            String found = String.format(
                    Locale.ROOT, "a robot stood for 1 s, torso %.2f m high, computed in %.1f s", height, seconds);
            return height < MIN_TORSO_HEIGHT
                    ? Finding.broken(
                            SUBJECT, found, "The robot has fallen. Please report this with the output of this command.")
                    : Finding.well(SUBJECT, found);
        } catch (IOException | RuntimeException failed) {
            return Finding.broken(SUBJECT, failed.toString(), "Please report this with the output of this command.");
        }
    }

    private static double torsoHeightAfterOneSecond() throws IOException {
        AtomicReference<WorldSnapshot> latest = new AtomicReference<>();
        SimulatorSettings settings = SimulatorSettings.of(WorldSettings.beginner())
                .withAgentPort(0)
                .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                .withAwaitedAgents(1);
        try (Simulator simulator = Simulator.start(settings, Console.silent());
                AgentLink link = simulator.connect()) {
            simulator.control().addObserver(latest::set);
            stand(link);
            return Optional.ofNullable(latest.get())
                    .orElseThrow()
                    .robots()
                    .get(0)
                    .body()
                    .position()
                    .z();
        }
    }

    private static void stand(AgentLink link) throws IOException {
        say(link, "(scene " + CreateRobot.SCENE + ")");
        say(link, "(init (unum 1)(teamname Doctor))");
        for (int cycle = 0; cycle < CYCLES; cycle++) {
            say(link, "");
        }
    }

    private static void say(AgentLink link, String words) throws IOException {
        MessageBuffer message = new MessageBuffer();
        message.append(words + EffectorMessageWriter.SYNCHRONISE);
        link.send(message);
        link.receive(message);
    }
}
