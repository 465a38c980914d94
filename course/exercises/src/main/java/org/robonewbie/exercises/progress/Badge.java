package org.robonewbie.exercises.progress;

import java.util.List;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Score;

/** What somebody, or a team together, has reached in the exercises. */
public enum Badge {
    /** An exercise is passed. */
    FIRST_SUCCESS("First success", "one exercise passed", Rule.passed("", 1)),
    /** All easy ones are passed. */
    FIRST_STEPS("First steps", "all exercises of the level first steps passed", Rule.all("first steps")),
    /** All of medium difficulty are passed. */
    BASICS("Basics", "all exercises of the level basics passed", Rule.all("basics")),
    /** All difficult ones are passed. */
    ADVANCED("Advanced", "all exercises of the level advanced passed", Rule.all("advanced")),
    /** All most difficult ones are passed. */
    CHALLENGER("Challenger", "all exercises of the level challenge passed", Rule.all("challenge")),
    /** Five exercises could not be solved better. */
    PERFECTIONIST("Perfectionist", "ten points in five exercises", new Rule("", 5, Score.MOST_POINTS, 0, false)),
    /** Five exercises are passed without help. */
    OWN_WAY("Own way", "five exercises passed without a hint or a solution", new Rule("", 5, 0, 0, true)),
    /** An exercise is passed after many tries. */
    PERSISTENT("Persistent", "an exercise passed after ten tries or more", new Rule("", 1, 0, 10, false)),
    /** Everything is passed. */
    WHOLE_COURSE("The whole course", "all exercises passed", Rule.all(""));

    private final String title;
    private final String reason;

    @SuppressWarnings("ImmutableEnumChecker") // a record of a word and numbers
    private final Rule rule;

    /**
     * What earns a badge: exercises that are passed, and how.
     *
     * @param level of the exercises that count; empty if all do
     * @param exercises how many of them it takes; 0 for all
     * @param leastPoints best points of each of them
     * @param leastTries how often each of them was graded
     * @param alone whether hints and solutions spoil it
     */
    public record Rule(String level, int exercises, double leastPoints, int leastTries, boolean alone) {

        private static Rule passed(String level, int exercises) {
            return new Rule(level, exercises, 0, 0, false);
        }

        private static Rule all(String level) {
            return passed(level, 0);
        }

        /** {@return the exercises that count} */
        public List<Exercise> counting() {
            return Exercises.all().stream()
                    .filter(each -> level.isEmpty() || each.level().equals(level))
                    .toList();
        }

        /** {@return how many of them it takes} */
        public int needed() {
            return exercises == 0 ? counting().size() : exercises;
        }

        private boolean isKeptBy(Progress progress) {
            long earned =
                    counting().stream().map(progress::of).filter(this::counts).count();
            return earned >= needed();
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

    /** {@return its name for people} */
    public String title() {
        return title;
    }

    /** {@return what it is given for} */
    public String reason() {
        return reason;
    }

    /** {@return what earns it} */
    public Rule rule() {
        return rule;
    }

    boolean isEarnedBy(Progress progress) {
        return rule.isKeptBy(progress);
    }
}
