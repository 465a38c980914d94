package org.robonewbie.studio;

import org.robonewbie.protocol.telemetry.TuningRequests;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** The objects on which a page's commands operate. */
interface StudioContext {

    SimulationControl simulation();

    UndoManager undoManager();

    CommandQueue commandQueue();

    /** Values that the user has set for tunable parameters of the robots' programs. */
    TuningRequests numbers();

    /** The robots that are steered by hand. */
    PuppetService puppets();

    /**
     * The latest state of the world.
     *
     * @throws IllegalStateException if the simulation has not started
     */
    WorldSnapshot now();
}
