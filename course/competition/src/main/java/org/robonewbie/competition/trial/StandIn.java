package org.robonewbie.competition.trial;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.simulator.server.Simulator;

/** Agent without a robot, which only synchronises so that the simulator does not wait for agents that never join. */
final class StandIn {

    private StandIn() {}

    static void connect(Simulator simulator) {
        AgentLink link = simulator.connect();
        MessageBuffer message = new MessageBuffer();
        message.append(EffectorMessageWriter.SYNCHRONISE);
        try {
            link.send(message);
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }
}
