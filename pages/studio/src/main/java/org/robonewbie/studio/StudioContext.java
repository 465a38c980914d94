package org.robonewbie.studio;

import org.robonewbie.protocol.telemetry.NumberWishes;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** What a page can act upon. */
interface StudioContext {

    /** The running simulation. */
    SimulationControl simulation();

    /** What people do to the world, so that it can be undone. */
    UndoManager undoManager();

    /** Where what people do waits for the world. */
    CommandQueue commandQueue();

    /** What people want of the numbers of robots' programs. */
    NumberWishes numbers();

    /** The robots that are steered by hand. */
    PuppetService puppets();

    /**
     * The present state of the world.
     *
     * @throws IllegalStateException if there was none yet
     */
    WorldSnapshot now();
}
