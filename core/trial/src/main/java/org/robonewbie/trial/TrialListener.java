package org.robonewbie.trial;

/** A listener for the cycles of a running trial. */
@FunctionalInterface
public interface TrialListener {

    /** A listener that does nothing. */
    TrialListener NONE = trial -> {};

    /**
     * Called after each cycle, including those in which robots settle at their start poses. The next cycle does not start until
     * this method returns.
     *
     * @param trial the trial
     */
    void cycleEnded(Trial trial);
}
