package org.robonewbie.learning.series;

import java.util.List;
import java.util.function.IntConsumer;

/** Something that carries out trials; which one does never changes the result. Found by {@link java.util.ServiceLoader}. */
public interface ExperimentEngine {

    /** {@return the engine's name on the command line, such as {@code local}} */
    String label();

    /**
     * Runs all trials.
     *
     * @param experiment full name of the experiment's class
     * @param trials the trials
     * @param master where, in the engine's own notation; empty for its usual place
     * @param progress called with the number of finished trials, now and then, from any thread
     * @return the measured numbers of each trial in the order of the trials
     */
    List<double[]> run(String experiment, List<PlannedTrial> trials, String master, IntConsumer progress);
}
