package org.robonewbie.learning.series;

import java.util.List;
import java.util.function.IntConsumer;

/** Something that carries out trials; which one does never changes the result. Found by {@link java.util.ServiceLoader}. */
public interface ExperimentEngine {

    /**
     * Names the engine as on the command line.
     *
     * @return a name such as {@code local}
     */
    String label();

    /**
     * Carries out all trials.
     *
     * @param experiment full name of the experiment's class
     * @param trials what is to be done
     * @param master where, in the engine's own words; empty for its usual place
     * @param progress is told how many trials are done, now and then, from any thread
     * @return the measured numbers of each trial in the order of the trials
     */
    List<double[]> run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress);
}
