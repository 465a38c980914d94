package org.robonewbie.exercises.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;

class BadgeTest {

    private static Progress all(ExerciseProgress state) {
        return new Progress(Exercises.all().stream().collect(Collectors.toMap(Exercise::name, any -> state)));
    }

    @Test
    void wholeCourseWithoutHelpEarnsEachBadge() {
        Progress done = all(new ExerciseProgress(10, 10, true, 60, 0, false, ""));

        assertThat(done.badges()).containsExactly(Badge.values());
    }

    @Test
    void tryingAloneEarnsNone() {
        Progress tried = all(new ExerciseProgress(12, 9, false, 60, 0, false, ""));

        assertThat(tried.badges()).isEmpty();
    }

    @Test
    void helpCostsTheBadgeOfTheOwnWayAndNothingElse() {
        Progress helped = all(new ExerciseProgress(10, 10, true, 60, 1, false, ""));

        assertThat(helped.badges()).doesNotContain(Badge.OWN_WAY).hasSize(Badge.values().length - 1);
    }

    @Test
    void levelsHaveBadgesOfTheirOwn() {
        Progress easy = new Progress(Exercises.all().stream()
                .filter(exercise -> exercise.level().equals("first steps"))
                .collect(Collectors.toMap(Exercise::name, any -> new ExerciseProgress(1, 8, true, 60, 3, false, ""))));

        assertThat(easy.badges()).containsExactly(Badge.FIRST_SUCCESS, Badge.FIRST_STEPS);
        assertThat(new Progress(Map.of()).badges()).isEmpty();
    }
}
