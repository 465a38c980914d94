package org.robonewbie.studio;

import org.robonewbie.protocol.telemetry.TuningRequests;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** The objects on which a page's commands operate. */
interface StudioContext {

    SimulationControl simulation();

    UndoManager undoManager();

    CommandQueue commandQueue();

    /** Returns the values that the user has set for tunable parameters of the robots' programs. */
    TuningRequests numbers();

    /** Returns the service for manually controlled robots. */
    PuppetService puppets();

    /**
     * Returns the latest state of the world.
     *
     * @throws IllegalStateException if the simulation has not started
     */
    WorldSnapshot now();
}
