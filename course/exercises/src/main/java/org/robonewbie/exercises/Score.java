package org.robonewbie.exercises;

import org.robonewbie.agent.log.NegativeZeroFormat;

/**
 * Score of one trial of an exercise.
 *
 * @param passed whether the exercise was solved
 * @param points 0 to 10; 10 only if the exercise was solved
 * @param finding measured result, as a sentence
 * @param hint what to try next; may be empty
 */
public record Score(boolean passed, int points, String finding, String hint) {

    /** Maximum points of a trial. */
    public static final int MAX_POINTS = 10;

    /** Creates a score. A negative zero in the finding loses its sign. */
    public Score {
        finding = NegativeZeroFormat.removed(finding);
    }

    /**
     * Returns the score of a solved exercise.
     *
     * @param finding measured result
     * @return a score with the maximum points
     */
    public static Score passed(String finding) {
        return new Score(true, MAX_POINTS, finding, "");
    }

    /**
     * Returns the score of a solved exercise that can be improved.
     *
     * @param points 1 to 10
     * @param finding measured result
     * @param hint what to improve
     * @return the score
     */
    public static Score passed(int points, String finding, String hint) {
        return new Score(true, Math.max(1, Math.min(MAX_POINTS, points)), finding, hint);
    }

    /**
     * Returns the score of an unsolved exercise.
     *
     * @param points points for partial success, 0 to 9
     * @param finding measured result
     * @param hint what to try next
     * @return the score
     */
    public static Score failed(double points, String finding, String hint) {
        int limited = (int) Math.max(0, Math.min(MAX_POINTS - 1, points));
        return new Score(false, limited, finding, hint);
    }

    /** {@return the score of a trial that was skipped because the program hung in an earlier one} */
    public static Score notTried() {
        return failed(0, "Skipped because an earlier trial did not finish.", "");
    }

    /**
     * Replaces the hint.
     *
     * @param other the new hint
     * @return a copy with the new hint
     */
    public Score withHint(String other) {
        return new Score(passed, points, finding, other);
    }

    /**
     * Translates the finding and the hint.
     *
     * @param language the language
     * @return a copy in the given language
     */
    public Score in(Language language) {
        return new Score(passed, points, language.translated(finding), language.translated(hint));
    }
}
