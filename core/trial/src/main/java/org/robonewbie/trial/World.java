package org.robonewbie.trial;

import java.util.List;

/** How commands get into the simulated world and readings out of it. */
interface World {

    /** Runs one cycle of 20 ms, in which the commands of all robots are on their way. */
    void cycle(List<TrialBody> bodies);

    /** Keeps the present state as the beginning of the trial. */
    void keep();

    /** Returns to the state that was kept, with other noise. */
    void reset(long seed);
}
