package org.robonewbie.exercises;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robonewbie.agent.Agent;

class FirstMinuteTest {

    /** A robot that stands still. */
    private static final class Idle extends Agent {
        @Override
        protected void think() {
            // does nothing
        }
    }

    static List<Exercise> levels() {
        return FirstMinute.levels();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void solutionPasses(Exercise level) {
        Score score = play(level, StartCodes.of(level, FirstMinute.solution(level)));

        assertThat(score).isEqualTo(Score.passed(score.finding()));
    }

    @ParameterizedTest
    @MethodSource("levels")
    void starterCodeFailsAndGetsAHint(Exercise level) {
        Score score = play(level, StartCodes.of(level));

        assertThat(score.passed()).isFalse();
        assertThat(score.hint()).isNotEmpty();
        assertThat(score.finding()).doesNotContain("The program ended with");
    }

    @ParameterizedTest
    @MethodSource("levels")
    void programThatDoesNothingFails(Exercise level) {
        assertThat(play(level, Idle::new).passed()).isFalse();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void solutionChangesNoMoreThanThreeLines(Exercise level) {
        List<String> before = level.startCode().lines().toList();
        List<String> after = FirstMinute.solution(level).lines().toList();

        assertThat(after).hasSameSizeAs(before);
        assertThat(java.util.stream.IntStream.range(0, before.size())
                        .filter(line -> !before.get(line).equals(after.get(line)))
                        .count())
                .isBetween(1L, 3L);
    }

    @ParameterizedTest
    @MethodSource("levels")
    void levelHasATranslation(Exercise level) {
        assertThat(List.of(level.title(), level.goal()))
                .noneMatch(text -> Language.GERMAN.translated(text).equals(text));
    }

    @Test
    void levelsDoNotCountAsExercises() {
        assertThat(Exercises.all()).doesNotContainAnyElementsOf(FirstMinute.levels());
        assertThat(FirstMinute.find("wave")).contains(FirstMinute.levels().get(0));
        assertThat(FirstMinute.find("kick")).isEmpty();
    }

    private static Score play(Exercise level, Supplier<Agent> program) {
        return new Grader()
                .grade(level, program, List.of(1L), Optional.empty())
                .trials()
                .get(0)
                .score();
    }
}
