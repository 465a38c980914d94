package org.robonewbie.protocol.embedded;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** A simulator that this program has started or found. */
public interface EmbeddedSimulator extends AutoCloseable {

    /**
     * Connects a new agent.
     *
     * @return the agent's end of the connection
     * @throws java.io.IOException if a simulator in another process does not respond
     */
    AgentLink connect() throws IOException;

    /**
     * {@return whether the simulator is a separate server: it does not end the run by itself, and robots should join it one at a
     * time}
     */
    default boolean isServer() {
        return false;
    }

    /** {@return a sentence about the simulator without its full stop, for users} */
    default String description() {
        return "Started a simulator on agent port " + agentPort();
    }

    /** {@return the TCP port on 127.0.0.1 for agents in other processes} */
    int agentPort();

    /** {@return a message to print: a one-time URL that opens the studio, and a hint; empty when headless} */
    Optional<String> studioAddress();

    /**
     * {@return the sink for the telemetry of robots in this process; {@link TelemetrySink#NONE} if none is attached}
     */
    default TelemetrySink telemetry() {
        return TelemetrySink.NONE;
    }

    /**
     * Stops the simulation, closes the recording and writes the report. Closing again has no effect.
     *
     * @throws java.io.UncheckedIOException if the report cannot be written
     */
    @Override
    void close();
}
