package org.robonewbie.competition.trial;

import java.io.IOException;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.simulator.SimulationControl;

/** Live viewers of trials. */
public interface Spectators {

    /** No viewers; trials run as fast as possible. */
    Spectators NOBODY = new Spectators() {
        @Override
        public Runnable watch(SimulationControl simulation, ContestTrial trial) {
            return () -> {};
        }

        @Override
        public boolean isNobody() {
            return true;
        }
    };

    /**
     * Shows a trial.
     *
     * @param simulation the simulation to show
     * @param trial the trial
     * @return an action that the caller must run at the end of the trial
     * @throws IOException if it cannot be shown
     */
    Runnable watch(SimulationControl simulation, ContestTrial trial) throws IOException;

    /**
     * Called with the progress of the contest at its start and after each trial. Calls do not overlap.
     *
     * @param progress current progress
     */
    default void stands(ContestProgress progress) {}

    /**
     * Returns whether there are no viewers.
     *
     * @return whether trials may run faster than real time
     */
    default boolean isNobody() {
        return false;
    }
}
