package org.robonewbie.exercises;

import java.util.function.Supplier;

/**
 * One trial of an exercise: it sets the scene, watches what truly happens, and judges.
 *
 * <p>A task is made anew for each trial, so it may keep what it has seen.
 */
public interface Task {

    /**
     * Puts robots and ball in their places. When it returns, the trial begins.
     *
     * @param stage the stage, still without robots
     * @param student makes a robot with the student's program
     */
    void begin(Stage stage, Supplier<? extends Program> student);

    /**
     * Looks at the world after a cycle; it may also move what the student's robot does not move.
     *
     * @param stage the stage
     */
    void watch(Stage stage);

    /**
     * Tells whether the trial may end before its time.
     *
     * @return whether nothing can change the score any more
     */
    default boolean isDecided() {
        return false;
    }

    /**
     * Judges, when the trial is over.
     *
     * @return the score
     */
    Score score();
}
