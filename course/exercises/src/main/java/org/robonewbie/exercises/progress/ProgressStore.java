package org.robonewbie.exercises.progress;

import java.util.function.UnaryOperator;
import org.robonewbie.exercises.Exercise;

/** Storage of a student's progress. */
public interface ProgressStore {

    /** {@return the stored progress; empty before the first exercise} */
    Progress read();

    /**
     * Changes and stores the state of one exercise.
     *
     * @param exercise the exercise
     * @param change computes the new state from the stored one
     * @return the new state
     */
    ExerciseProgress update(Exercise exercise, UnaryOperator<ExerciseProgress> change);
}
