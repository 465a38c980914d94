package org.robonewbie.learning.series;

/** Takes what trials measure, one after the other, from any thread. */
public interface TrialSink {

    /**
     * Takes the numbers of a trial.
     *
     * @param trial the trial
     * @param numbers what it has measured
     */
    void measured(PlannedTrial trial, double[] numbers);

    /**
     * Takes note of a trial that has failed for good.
     *
     * @param trial the trial
     * @param why what happened, as a sentence that names the trial
     */
    void failed(PlannedTrial trial, String why);
}
