package org.robonewbie.exercises;

import org.robonewbie.agent.log.NegativeZeroFormat;

/**
 * How one trial of an exercise ended.
 *
 * @param passed whether the task is solved
 * @param points 0 to 10; 10 is reached only by who passes
 * @param finding what was measured, as a sentence
 * @param hint what to try next, empty if there is nothing to add
 */
public record Score(boolean passed, int points, String finding, String hint) {

    /** The points of a perfect trial. */
    public static final int MOST_POINTS = 10;

    /** Writes a small number that was rounded to minus zero as zero. */
    public Score {
        finding = NegativeZeroFormat.removed(finding);
    }

    /**
     * Returns the score of a solved task.
     *
     * @param finding what was measured
     * @return a score with all points
     */
    public static Score passed(String finding) {
        return new Score(true, MOST_POINTS, finding, "");
    }

    /**
     * Returns the score of a solved task that could be solved better.
     *
     * @param points 1 to 10
     * @param finding what was measured
     * @param hint what could be better
     * @return the score
     */
    public static Score passed(int points, String finding, String hint) {
        return new Score(true, Math.max(1, Math.min(MOST_POINTS, points)), finding, hint);
    }

    /**
     * Returns the score of an unsolved task.
     *
     * @param points what is reached all the same, 0 to 9
     * @param finding what was measured
     * @param hint what to try next
     * @return the score
     */
    public static Score failed(double points, String finding, String hint) {
        int limited = (int) Math.max(0, Math.min(MOST_POINTS - 1, points));
        return new Score(false, limited, finding, hint);
    }

    /** {@return the score of a trial that was not begun, since a program is stuck in those before} */
    public static Score notTried() {
        return failed(0, "Not tried, since the trials before did not end.", "");
    }

    /**
     * Replaces the hint.
     *
     * @param other what to do instead
     * @return the same score with this hint
     */
    public Score withHint(String other) {
        return new Score(passed, points, finding, other);
    }

    /**
     * Translates finding and hint.
     *
     * @param language the language
     * @return the same score in this language
     */
    public Score in(Language language) {
        return new Score(passed, points, language.translated(finding), language.translated(hint));
    }
}
