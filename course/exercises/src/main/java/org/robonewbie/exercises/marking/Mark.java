package org.robonewbie.exercises.marking;

import java.util.Optional;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Score;

/**
 * A student's result in one exercise.
 *
 * @param student name of the student
 * @param exercise name of the exercise
 * @param grade the grade; empty if the program could not be started
 * @param reason why the program could not be started, such as the compiler's first error; empty if there is a grade
 */
record Mark(String student, String exercise, Optional<Grade> grade, String reason) {

    double points() {
        return grade.map(Grade::points).orElse(0.0);
    }

    boolean passed() {
        return grade.map(Grade::passed).orElse(false);
    }

    /** Returns the finding of the first failed trial, or the reason why there was no trial. */
    String finding() {
        return grade.stream()
                .flatMap(given -> given.trials().stream().map(Grade.SeededScore::score))
                .filter(score -> !score.passed())
                .map(Score::finding)
                .findFirst()
                .orElse(reason);
    }
}
