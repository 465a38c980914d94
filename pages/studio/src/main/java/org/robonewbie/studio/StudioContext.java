package org.robonewbie.studio;

import org.robonewbie.protocol.telemetry.TuningRequests;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** What the commands of a page act on. */
interface StudioContext {

    SimulationControl simulation();

    /** Undo and redo of the user's changes. */
    UndoManager undoManager();

    /** Queue of the user's commands. */
    CommandQueue commandQueue();

    /** Values that the user has set for tunable numbers of robots' programs. */
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
