package org.robonewbie.protocol.embedded;

import java.io.IOException;

/**
 * Starts simulators inside this process. The simulator module registers one with {@link java.util.ServiceLoader}, so that the
 * agent module does not depend on it.
 */
public interface SimulatorProvider {

    /**
     * Starts a simulator; its clock is stopped until the awaited number of agents is connected.
     *
     * @param request the wanted configuration
     * @return the running simulator
     * @throws IOException if a port is in use or a file cannot be written; the message says what to do
     */
    EmbeddedSimulator start(SimulatorRequest request) throws IOException;
}
