package org.robonewbie.protocol.embedded;

import java.io.IOException;

/**
 * Factory for simulators in this process. The simulator module provides it through {@link java.util.ServiceLoader}, so that the
 * agent module does not depend on the simulator module.
 */
public interface SimulatorProvider {

    /**
     * Returns whether the simulators of this provider have a robot.
     *
     * @param robot name of the robot, such as {@code NAO}
     * @return whether {@link #start} can be called for it
     */
    default boolean has(String robot) {
        return robot.equals("NAO");
    }

    /**
     * Starts a simulator. Its clock starts once the required number of agents have connected.
     *
     * @param request the configuration
     * @return the running simulator
     * @throws IOException if a port is in use or a file cannot be written; the message says what to do
     */
    EmbeddedSimulator start(SimulatorRequest request) throws IOException;
}
