package org.robonewbie.exercises.progress;

import java.util.List;
import java.util.function.Predicate;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Score;

/** What somebody, or a team together, has reached in the exercises. */
public enum Badge {
    /** An exercise is passed. */
    FIRST_SUCCESS("First success", "one exercise passed", done -> done.passed() >= 1),
    /** All easy ones are passed. */
    FIRST_STEPS("First steps", "all exercises of the level first steps passed", level("first steps")),
    /** All of medium difficulty are passed. */
    BASICS("Basics", "all exercises of the level basics passed", level("basics")),
    /** All difficult ones are passed. */
    ADVANCED("Advanced", "all exercises of the level advanced passed", level("advanced")),
    /** All most difficult ones are passed. */
    CHALLENGER("Challenger", "all exercises of the level challenge passed", level("challenge")),
    /** Five exercises could not be solved better. */
    PERFECTIONIST("Perfectionist", "ten points in five exercises", done -> perfect(done) >= Badge.FIVE),
    /** Five exercises are passed without help. */
    OWN_WAY(
            "Own way",
            "five exercises passed without a hint or a solution",
            done -> Exercises.all().stream()
                            .map(done::of)
                            .filter(Badge::isAlone)
                            .count()
                    >= Badge.FIVE),
    /** An exercise is passed after many tries. */
    PERSISTENT(
            "Persistent",
            "an exercise passed after ten tries or more",
            done -> Exercises.all().stream()
                    .map(done::of)
                    .anyMatch(each -> each.passed() && each.tries() >= Badge.MANY)),
    /** Everything is passed. */
    WHOLE_COURSE("The whole course", "all exercises passed", done -> all(Exercises.all(), done));

    private static final int FIVE = 5;
    private static final int MANY = 10;

    private final String title;
    private final String reason;

    @SuppressWarnings("ImmutableEnumChecker")
    private final Predicate<Progress> rule;

    Badge(String title, String reason, Predicate<Progress> rule) {
        this.title = title;
        this.reason = reason;
        this.rule = rule;
    }

    /** {@return its name for people} */
    public String title() {
        return title;
    }

    /** {@return what it is given for} */
    public String reason() {
        return reason;
    }

    boolean isEarnedBy(Progress progress) {
        return rule.test(progress);
    }

    private static Predicate<Progress> level(String level) {
        return done -> all(
                Exercises.all().stream()
                        .filter(each -> each.level().equals(level))
                        .toList(),
                done);
    }

    private static boolean all(List<Exercise> exercises, Progress done) {
        return !exercises.isEmpty()
                && exercises.stream().allMatch(each -> done.of(each).passed());
    }

    private static long perfect(Progress done) {
        return Exercises.all().stream()
                .filter(each -> done.of(each).passed() && done.of(each).bestPoints() >= Score.MOST_POINTS)
                .count();
    }

    private static boolean isAlone(ExerciseProgress state) {
        return state.passed() && state.hints() == 0 && !state.solutionSeen();
    }
}
