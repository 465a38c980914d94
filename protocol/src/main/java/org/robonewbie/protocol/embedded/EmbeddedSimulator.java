package org.robonewbie.protocol.embedded;

import java.net.URI;
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

    /**
     * Tells where agents of other processes can join.
     *
     * @return the TCP port on 127.0.0.1
     */
    int agentPort();

    /**
     * Tells where the studio can be seen.
     *
     * @return the address for a browser, or empty when headless
     */
    Optional<URI> studioAddress();

    /**
     * Tells who is interested in what the robots of this process think.
     *
     * @return takes their log lines, beliefs and drawings; {@link TelemetrySink#NONE} if nobody watches
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
