package org.robonewbie.exercises;

/** Looks at a trial while it goes on. */
@FunctionalInterface
public interface Audience {

    /** An audience that is not there. */
    Audience NOBODY = stage -> {};

    /**
     * Sees the world after a cycle, also while the scene is still being set; the next cycle waits until this method returns.
     *
     * @param stage the stage
     */
    void cycleEnded(Stage stage);
}
