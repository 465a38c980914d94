package org.robonewbie.studio;

import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.WorldSnapshot;

/** What a page can act upon. */
interface Stage {

    /** Gives the running simulation. */
    SimulationControl simulation();

    /** Gives the robots that people steer. */
    PuppetDesk puppets();

    /**
     * Gives the state of the world.
     *
     * @throws IllegalStateException if there was none yet
     */
    WorldSnapshot now();
}
