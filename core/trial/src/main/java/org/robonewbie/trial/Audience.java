package org.robonewbie.trial;

/** Watches a running trial. */
@FunctionalInterface
public interface Audience {

    /** An audience that is not there. */
    Audience NOBODY = trial -> {};

    /**
     * Sees the world after a cycle, also while the scene is still being set; the next cycle waits until this method returns.
     *
     * @param trial the trial
     */
    void cycleEnded(Trial trial);
}
