package org.robonewbie.protocol.embedded;

import java.util.Optional;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.telemetry.TelemetrySink;

/** A simulator that runs inside this process and in lock-step with its agents. */
public interface EmbeddedSimulator extends AutoCloseable {

    /**
     * Connects a new agent without a socket.
     *
     * @return the agent's end of the connection
     */
    AgentLink connect();

    /** {@return the TCP port on 127.0.0.1 at which agents of other processes can join} */
    int agentPort();

    /** {@return what to print about the studio: an address that opens it once, and a hint; or empty when headless} */
    Optional<String> studioAddress();

    /**
     * {@return the sink for log lines, beliefs and drawings of this process's robots; {@link TelemetrySink#NONE} if none is
     * attached}
     */
    default TelemetrySink telemetry() {
        return TelemetrySink.NONE;
    }

    /**
     * Ends the simulation, closes the recording and writes the report. Closing twice does nothing.
     *
     * @throws java.io.UncheckedIOException if the report cannot be written
     */
    @Override
    void close();
}
