package org.robonewbie.simulator;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;

/** A running simulator that is joined by the program that has started or found it. */
public interface JoinableSimulator extends AutoCloseable {

    /**
     * Connects a new agent.
     *
     * @return the agent's end of the connection
     * @throws IOException if a simulator in another process does not respond
     */
    AgentLink connect() throws IOException;

    /** {@return the TCP port on 127.0.0.1 for agents in other processes} */
    int agentPort();

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

    /**
     * Returns the simulation for a view.
     *
     * @return the simulation
     * @throws IOException if it cannot be watched
     */
    SimulationControl control() throws IOException;

    /**
     * Waits until the simulation ends or is closed.
     *
     * @throws InterruptedException if this thread is interrupted
     */
    void awaitEnd() throws InterruptedException;

    /** Ends the simulation. Closing again has no effect. */
    @Override
    void close();
}
