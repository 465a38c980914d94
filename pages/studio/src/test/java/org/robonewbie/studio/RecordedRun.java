package org.robonewbie.studio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.server.Simulator;
import org.robonewbie.simulator.server.SimulatorSettings;

/** A short recorded run of the real simulator: a robot bends until it falls, and the ball is placed into a goal. */
final class RecordedRun implements AutoCloseable {

    private final Simulator simulator;
    private final AgentLink link;
    private final MessageBuffer message = new MessageBuffer();

    RecordedRun(Path file) throws IOException {
        simulator = Simulator.start(
                SimulatorSettings.of(WorldSettings.beginner().withSeed(1))
                        .withAgentPort(0)
                        .withAwaitedAgents(1)
                        .withSpeed(SimulationControl.AS_FAST_AS_POSSIBLE)
                        .withOutput(Optional.of(file), Optional.empty()),
                Console.standard());
        link = simulator.connect();
        say("(scene rsg/agent/nao/nao.rsg)(syn)");
        say("(init (unum 1)(teamname Ada))(syn)");
        say("(syn)");
    }

    RecordedRun cycles(int count, String effectors) throws IOException {
        for (int i = 0; i < count; i++) {
            say(effectors + "(syn)");
        }
        return this;
    }

    /** Records four seconds with a goal and a fall. */
    static void write(Path file) throws IOException {
        try (RecordedRun run = new RecordedRun(file)) {
            run.cycles(60, "");
            run.simulator.control().order(new Order.DropBall());
            run.cycles(5, "");
            run.simulator.control().order(new Order.MoveBall(new Vector3(6.1, 0, 0.1), Vector3.ZERO));
            run.cycles(20, "").cycles(60, "(lle3 4)(rle3 4)(he1 1)").cycles(60, "");
        }
    }

    private void say(String text) throws IOException {
        message.clear();
        message.append(text);
        link.send(message);
        link.receive(message);
    }

    @Override
    public void close() {
        simulator.close();
        link.close();
    }
}
