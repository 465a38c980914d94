package org.robonewbie.competition.trial;

import java.io.IOException;
import org.robonewbie.competition.contest.Trial;
import org.robonewbie.simulator.SimulationControl;

/** Those who look at trials while they run. */
public interface Spectators {

    /** Nobody looks, so trials run as fast as they can. */
    Spectators NOBODY = new Spectators() {
        @Override
        public Runnable watch(SimulationControl simulation, Trial trial) {
            return () -> {};
        }

        @Override
        public boolean isNobody() {
            return true;
        }
    };

    /**
     * Lets them look at a trial.
     *
     * @param simulation what to look at
     * @param trial which trial it is
     * @return what to do at the end of the trial
     * @throws IOException if they cannot look
     */
    Runnable watch(SimulationControl simulation, Trial trial) throws IOException;

    /**
     * Tells whether there is nobody.
     *
     * @return whether trials need not keep real time
     */
    default boolean isNobody() {
        return false;
    }
}
