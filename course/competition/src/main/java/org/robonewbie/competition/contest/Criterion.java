package org.robonewbie.competition.contest;

import java.util.Locale;
import java.util.Optional;

/**
 * A column of the table, by which teams are compared: the sum of a figure over all trials of a team. They are compared as
 * precisely as the table shows it, so that everybody can check the ranking with the printed table.
 *
 * @param figure name of the figure
 * @param title head of its column
 * @param format how its value is shown, as for {@link String#format}; the number comes first, and a blank after it
 * @param better 1 if more is better, -1 if less is better, 0 if it is only shown
 * @param missing what a trial counts in which it was not reached, or that is lost; not a number if the team has no value then
 */
public record Criterion(String figure, String title, String format, int better, double missing) {

    /**
     * Compares by something of which more is better.
     *
     * @param figure name of the figure
     * @param title head of its column
     * @param format how its value is shown
     * @return the criterion
     */
    public static Criterion most(String figure, String title, String format) {
        return new Criterion(figure, title, format, 1, Double.NaN);
    }

    /**
     * Compares by something of which less is better.
     *
     * @param figure name of the figure
     * @param title head of its column
     * @param format how its value is shown
     * @return the criterion
     */
    public static Criterion least(String figure, String title, String format) {
        return new Criterion(figure, title, format, -1, Double.NaN);
    }

    /**
     * Compares by points, of which a lost trial has none.
     *
     * @param figure name of the figure
     * @param title head of its column
     * @param most what can be reached in all trials
     * @return the criterion
     */
    public static Criterion points(String figure, String title, int most) {
        return new Criterion(figure, title, "%.0f of " + most, 1, 0);
    }

    /**
     * Keeps the column in the table, but compares by other ones.
     *
     * @return a changed copy
     */
    public Criterion onlyShown() {
        return new Criterion(figure, title, format, 0, missing);
    }

    /** What one trial adds. */
    double valueIn(Optional<TeamResult> result) {
        return result.map(found -> found.figure(figure).orElse(missing)).orElse(missing);
    }

    /** A place in the order of teams: the smallest first; those without a value stand behind all others. */
    double order(double value) {
        if (better == 0 || Double.isNaN(value)) {
            return better == 0 ? 0 : value;
        }
        double shown = Double.parseDouble(text(value).split(" ", 2)[0]);
        return 0.0 - better * shown; // so that there is only one zero
    }

    String text(double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, format, value);
    }
}
