package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ExercisesTest {

    private static final int MANY = 10;

    static List<Exercise> exercises() {
        return Exercises.all();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void referenceSolutionPassesAndTheSameSeedGivesTheSameScore(Exercise exercise) {
        Grade grade = new Grader().grade(exercise, Solutions.of(exercise), List.of(1L, 1L), Optional.empty());

        assertThat(grade.passed()).as(grade.toString()).isTrue();
        assertThat(grade.trials().get(1)).isEqualTo(grade.trials().get(0));
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("exercises")
    void referenceSolutionPassesWithManySeeds(Exercise exercise) {
        Grade grade = new Grader().grade(exercise, Solutions.of(exercise), MANY);

        assertThat(grade.trials()).hasSize(MANY);
        assertThat(grade.passed()).as(grade.toString()).isTrue();
    }

    @ParameterizedTest
    @MethodSource("exercises")
    void startCodeFailsAndGetsAHint(Exercise exercise) {
        checkStartCode(exercise, 1);
    }

    @Tag("slow")
    @ParameterizedTest
    @MethodSource("exercises")
    void startCodeFailsWithMoreSeedsToo(Exercise exercise) {
        checkStartCode(exercise, 3);
    }

    private static void checkStartCode(Exercise exercise, int seeds) {
        Grade grade = new Grader().grade(exercise, StartCodes.of(exercise), seeds);

        assertThat(grade.passed()).as(grade.toString()).isFalse();
        assertThat(grade.points()).as(grade.toString()).isLessThanOrEqualTo(3);
        assertThat(grade.toString()).contains("Hint: ").doesNotContain("The program ended with");
    }

    @Tag("slow")
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
