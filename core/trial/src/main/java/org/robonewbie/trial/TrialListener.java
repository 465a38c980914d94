package org.robonewbie.trial;

/** Watches a running trial. */
@FunctionalInterface
public interface TrialListener {

    /** An audience that is not there. */
    TrialListener NONE = trial -> {};

    /**
     * Sees the world after a cycle, also while the scene is still being set; the next cycle waits until this method returns.
     *
     * @param trial the trial
     */
    void cycleEnded(Trial trial);
}
