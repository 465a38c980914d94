package org.robonewbie.protocol.embedded;

import java.io.IOException;

/**
 * Starts simulators inside this process. The simulator module offers one by {@link java.util.ServiceLoader}, so that
 * the agent module needs no dependency on it.
 */
public interface SimulatorProvider {

    /**
     * Starts a simulator; its clock stands still until the awaited number of agents is connected.
     *
     * @param request what is wanted
     * @return the running simulator
     * @throws IOException if a port is in use or a file cannot be written; the message says what to do
     */
    EmbeddedSimulator start(SimulatorRequest request) throws IOException;
}
