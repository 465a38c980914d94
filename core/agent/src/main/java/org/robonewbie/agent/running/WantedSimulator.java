package org.robonewbie.agent.running;

import org.robonewbie.protocol.embedded.SimulatorRequest;

/**
 * The simulator to connect to.
 *
 * @param kind whether to join a server or to start a simulator
 * @param host name or address of the server's computer
 * @param port TCP port of the server
 * @param own how to start a simulator of this process
 */
public record WantedSimulator(Kind kind, String host, int port, SimulatorRequest own) {

    /** Whether to join a server or to start a simulator. */
    public enum Kind {
        /** The server, if it answers; else a simulator of this process. */
        ANY,
        /** The server and nothing else. */
        SERVER,
        /** A simulator of this process. */
        OWN
    }
}
