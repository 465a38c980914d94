package org.robonewbie.learning.series;

import java.util.List;
import java.util.function.IntConsumer;

/** Something that carries out trials; which one does never changes the result. Found by {@link java.util.ServiceLoader}. */
public interface ExperimentEngine extends AutoCloseable {

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

    /**
     * Runs all trials and passes on the result of each; as soon as it is there, if the engine knows it then.
     *
     * @param experiment full name of the experiment's class
     * @param trials the trials
     * @param master where, in the engine's own notation; empty for its usual place
     * @param progress called with the number of finished trials, now and then, from any thread
     * @param sink takes the results, in any order and from any thread
     */
    default void run(
            String experiment, List<PlannedTrial> trials, String master, IntConsumer progress, TrialSink sink) {
        List<double[]> all = run(experiment, trials, master, progress);
        for (int i = 0; i < trials.size(); i++) {
            sink.measured(trials.get(i), all.get(i));
        }
    }

    /** Lets go of what the engine holds from one run to the next, such as a connection to a cluster. */
    @Override
    default void close() {}
}
