package org.robonewbie.simulator;

import java.io.IOException;
import java.util.Optional;
import org.robonewbie.protocol.embedded.EmbeddedSimulator;

/** A simulator without a view, which is joined by the program that has started or found it. */
public interface JoinableSimulator extends EmbeddedSimulator {

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

    @Override
    default Optional<String> studioAddress() {
        return Optional.empty();
    }
}
