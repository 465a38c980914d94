package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ExercisesTest {

    private static final int SEEDS = 10;

    static List<Exercise> exercises() {
        return Exercises.all();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void referenceSolutionPassesWithTenSeeds(Exercise exercise) {
        Grade grade = new Grader().grade(exercise, Solutions.of(exercise), SEEDS);

        assertThat(grade.trials()).hasSize(SEEDS);
        assertThat(grade.passed()).as(grade.toString()).isTrue();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void startCodeFailsAndGetsAHint(Exercise exercise) {
        Grade grade = new Grader().grade(exercise, StartCodes.of(exercise), 3);

        assertThat(grade.passed()).as(grade.toString()).isFalse();
        assertThat(grade.toString()).contains("Hint: ").doesNotContain("The program ended with");
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void sameSeedGivesTheSameGrade(Exercise exercise) {
        Grade first = new Grader(1).grade(exercise, Solutions.of(exercise), 1);
        Grade second = new Grader(1).grade(exercise, Solutions.of(exercise), 1);

        assertThat(second.json()).isEqualTo(first.json());
    }

    @Test
    void exerciseIsFoundByNameNumberAndClass() {
        assertThat(List.of("kick", "12", "12-kick", "Kick"))
                .allSatisfy(name -> assertThat(Exercises.find(name))
                        .hasValueSatisfying(found -> assertThat(found.name()).isEqualTo("kick")));
        assertThat(Exercises.find("kickk")).isEmpty();
    }

    @Test
    void numbersFollowTheCourse() {
        assertThat(Exercises.all())
                .extracting(Exercise::number)
                .containsExactlyElementsOf(java.util.stream.IntStream.rangeClosed(
                                1, Exercises.all().size())
                        .boxed()
                        .toList());
    }
}
