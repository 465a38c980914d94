package org.robonewbie.trial;

import java.util.List;

/** The exchange of commands and readings with the simulated world. */
interface World {

    /** Runs one cycle of 20 ms with the commands of all robots. */
    void cycle(List<TrialBody> bodies);

    /** Saves the current state as the start of the trial. */
    void keep();

    /** Restores the saved state with a new seed. */
    void reset(long seed);
}
