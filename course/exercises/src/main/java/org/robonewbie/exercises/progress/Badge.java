package org.robonewbie.exercises.progress;

import java.util.List;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Score;

/** Awards that a student or a team receives for passing exercises. */
public enum Badge {
    /** One exercise passed. */
    FIRST_SUCCESS("First success", "one exercise passed", Rule.passed("", 1)),
    /** All exercises of the first level passed. */
    FIRST_STEPS("First steps", "all first-steps exercises passed", Rule.all("first steps")),
    /** All exercises of the second level passed. */
    BASICS("Basics", "all basics exercises passed", Rule.all("basics")),
    /** All exercises of the third level passed. */
    ADVANCED("Advanced", "all advanced exercises passed", Rule.all("advanced")),
    /** All exercises of the highest level passed. */
    CHALLENGER("Challenger", "all challenge exercises passed", Rule.all("challenge")),
    /** Full marks in five exercises. */
    PERFECTIONIST("Perfectionist", "ten points in five exercises", new Rule("", 5, Score.MAX_POINTS, 0, false)),
    /** Five exercises passed without help. */
    OWN_WAY("Own way", "five exercises passed without a hint or a solution", new Rule("", 5, 0, 0, true)),
    /** One exercise passed after ten or more tries. */
    PERSISTENT("Persistent", "an exercise passed after ten or more tries", new Rule("", 1, 0, 10, false)),
    /** All exercises passed. */
    WHOLE_COURSE("The whole course", "all exercises passed", Rule.all(""));

    private final String title;
    private final String reason;

    @SuppressWarnings("ImmutableEnumChecker") // a record of immutable values
    private final Rule rule;

    /**
     * Condition for a badge.
     *
     * @param level level of the exercises that count; empty for all levels
     * @param exercises number of exercises that must be passed; 0 for all exercises of the level
     * @param leastPoints minimum points required in the best try
     * @param leastTries minimum number of graded tries required
     * @param alone whether an exercise counts only if the student opened neither a hint nor a solution
     */
    private record Rule(String level, int exercises, double leastPoints, int leastTries, boolean alone) {

        private static Rule passed(String level, int exercises) {
            return new Rule(level, exercises, 0, 0, false);
        }

        private static Rule all(String level) {
            return passed(level, 0);
        }

        private boolean isMetBy(Progress progress) {
            List<ExerciseProgress> counting = Exercises.all().stream()
                    .filter(each -> level.isEmpty() || each.level().equals(level))
                    .map(progress::of)
                    .toList();
            long earned = counting.stream().filter(this::counts).count();
            return earned >= (exercises == 0 ? counting.size() : exercises);
        }

        private boolean counts(ExerciseProgress state) {
            boolean hadHelp = state.hints() > 0 || state.solutionSeen();
            return state.passed()
                    && state.bestPoints() >= leastPoints
                    && state.tries() >= leastTries
                    && !(alone && hadHelp);
        }
    }

    Badge(String title, String reason, Rule rule) {
        this.title = title;
        this.reason = reason;
        this.rule = rule;
    }

    /** {@return the display name} */
    public String title() {
        return title;
    }

    /** {@return the condition in words} */
    public String reason() {
        return reason;
    }

    boolean isEarnedBy(Progress progress) {
        return rule.isMetBy(progress);
    }
}
