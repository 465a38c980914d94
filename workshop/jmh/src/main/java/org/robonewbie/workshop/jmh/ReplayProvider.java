package org.robonewbie.workshop.jmh;

import java.util.Optional;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;
import org.robonewbie.protocol.embedded.SimulatorProvider;
import org.robonewbie.protocol.embedded.SimulatorRequest;
import org.robonewbie.protocol.frame.AgentLink;

/** Provider of a simulator that only replays recorded messages. */
public final class ReplayProvider implements SimulatorProvider {

    /** Creates the provider. */
    public ReplayProvider() {}

    @Override
    public EmbeddedSimulator start(SimulatorRequest request) {
        return new Replayed();
    }

    /** Simulator that replays recorded messages instead of simulating. */
    private static final class Replayed implements EmbeddedSimulator {

        @Override
        public AgentLink connect() {
            return new ReplayLink();
        }

        @Override
        public int agentPort() {
            return 0;
        }

        @Override
        public Optional<String> studioAddress() {
            return Optional.empty();
        }

        @Override
        public void close() {}
    }
}
