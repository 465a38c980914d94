package org.robonewbie.trial;

import java.util.List;

/** The simulated world, which exchanges commands for readings in each cycle. */
interface World {

    /** Executes the commands of all robots for one cycle of 20 ms and sets their new readings. */
    void cycle(List<TrialBody> bodies);

    /** Saves the current state as the start of the trial. */
    void keep();

    /** Replaces the physics engine until the world is reset. */
    void setPhysics(ExternalPhysics physics);

    /** Restores the saved state with a new seed and the simulator's own physics. */
    void reset(long seed);
}
