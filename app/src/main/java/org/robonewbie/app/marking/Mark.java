package org.robonewbie.app.marking;

import java.util.Optional;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.Score;

/**
 * What a student has earned in one exercise.
 *
 * @param student name of the student
 * @param exercise name of the exercise
 * @param grade the grade; empty if the program could not begin
 * @param reason why it could not begin, such as the compiler's first message; empty with a grade
 */
record Mark(String student, String exercise, Optional<Grade> grade, String reason) {

    double points() {
        return grade.map(Grade::points).orElse(0.0);
    }

    boolean passed() {
        return grade.map(Grade::passed).orElse(false);
    }

    /** What was measured in the first trial that failed, or why there was none. */
    String finding() {
        return grade.stream()
                .flatMap(given -> given.trials().stream().map(Grade.SeededScore::score))
                .filter(score -> !score.passed())
                .map(Score::finding)
                .findFirst()
                .orElse(reason);
    }
}
