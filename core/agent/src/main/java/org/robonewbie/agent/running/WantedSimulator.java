package org.robonewbie.agent.running;

import org.robonewbie.protocol.embedded.SimulatorRequest;

/**
 * The simulator to connect to.
 *
 * @param kind whether to join a server or to start an embedded simulator
 * @param host name or address of the server's computer
 * @param port TCP port of the server
 * @param own how to start an embedded simulator
 */
public record WantedSimulator(Kind kind, String host, int port, SimulatorRequest own) {

    /** Whether to join a server or to start an embedded simulator. */
    public enum Kind {
        /** The server if it responds, otherwise an embedded simulator. */
        ANY,
        /** The server only. */
        SERVER,
        /** An embedded simulator only. */
        OWN
    }
}
