package org.robonewbie.protocol.embedded;

import java.util.Optional;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** A simulator that runs in this process, in lock-step with its agents. */
public interface EmbeddedSimulator extends AutoCloseable {

    /**
     * Connects a new agent without a socket.
     *
     * @return the agent's end of the connection
     */
    AgentLink connect();

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
