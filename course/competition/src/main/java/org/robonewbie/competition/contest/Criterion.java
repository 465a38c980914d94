package org.robonewbie.competition.contest;

import java.util.Locale;
import java.util.Optional;

/**
 * Ranking criterion and column of the table: the sum of a measured value over all trials of a team. Values are compared as
 * rounded in the table, so that the ranking can be verified from the printed table.
 *
 * @param figure name of the measured value
 * @param title column heading
 * @param format {@link String#format} pattern, in which the number comes first, followed by a space if there is a unit
 * @param better 1 if larger values are better, -1 if smaller values are better, 0 if the column does not affect the ranking
 * @param missing value for a trial without a measurement; with NaN, the team gets no total
 */
public record Criterion(String figure, String title, String format, int better, double missing) {

    /**
     * Creates a criterion for which larger values are better.
     *
     * @param figure name of the measured value
     * @param title column heading
     * @param format {@link String#format} pattern for the value
     * @return the criterion
     */
    public static Criterion most(String figure, String title, String format) {
        return new Criterion(figure, title, format, 1, Double.NaN);
    }

    /**
     * Creates a criterion for which smaller values are better.
     *
     * @param figure name of the measured value
     * @param title column heading
     * @param format {@link String#format} pattern for the value
     * @return the criterion
     */
    public static Criterion least(String figure, String title, String format) {
        return new Criterion(figure, title, format, -1, Double.NaN);
    }

    /**
     * Creates a criterion for points; a forfeited trial counts as 0.
     *
     * @param figure name of the measured value
     * @param title column heading
     * @param most maximum total over all trials
     * @return the criterion
     */
    public static Criterion points(String figure, String title, int most) {
        return new Criterion(figure, title, "%.0f of " + most, 1, 0);
    }

    /**
     * Returns a copy that is shown as a column but does not affect the ranking.
     *
     * @return the copy
     */
    public Criterion onlyShown() {
        return new Criterion(figure, title, format, 0, missing);
    }

    double valueIn(Optional<TeamResult> result) {
        return result.map(found -> found.figure(figure).orElse(missing)).orElse(missing);
    }

    /** Returns the sort key of a value: the best value has the smallest key, and NaN is last. */
    double order(double value) {
        if (better == 0 || Double.isNaN(value)) {
            return better == 0 ? 0 : value;
        }
        double shown = Double.parseDouble(text(value).split(" ", 2)[0]);
        return 0.0 - better * shown; // avoids -0.0
    }

    String text(double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, format, value);
    }
}
