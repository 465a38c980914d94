package org.robonewbie.competition.trial;

import java.io.IOException;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.simulator.SimulationControl;

/** Those who look at trials while they run. */
public interface Spectators {

    /** No spectators, so trials run as fast as they can. */
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
     * @return what to do at the end of the trial
     * @throws IOException if it cannot be shown
     */
    Runnable watch(SimulationControl simulation, ContestTrial trial) throws IOException;

    /**
     * Is told how the contest stands, when it begins or goes on, and after each trial; by one thread at a time.
     *
     * @param progress how it stands
     */
    default void stands(ContestProgress progress) {}

    /**
     * Returns whether there are no spectators.
     *
     * @return whether trials need not keep real time
     */
    default boolean isNobody() {
        return false;
    }
}
