package org.robonewbie.competition.contest;

import java.util.Comparator;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * Something by which teams are compared. They are compared as precisely as the table shows it, so that everybody can check the
 * ranking with the printed table.
 *
 * @param figure name of the figure
 * @param title head of its column
 * @param format how its value is shown, as for {@link String#format}
 * @param more whether more is better, else less is
 */
public record Criterion(String figure, String title, String format, boolean more) {

    /** What is shown where nothing was reached. */
    static final String NOTHING = "–";

    /** The better ones first; who has not reached anything stands behind all others. */
    Comparator<TeamResult> order() {
        return Comparator.comparingDouble(result -> {
            OptionalDouble shown = result.figure(figure);
            double value = shown.isPresent() ? Double.parseDouble(number(shown.getAsDouble())) : Double.NaN;
            return (more ? -value : value) + 0.0; // so that there is only one zero
        });
    }

    String text(TeamResult result) {
        OptionalDouble value = result.figure(figure);
        return value.isPresent() ? String.format(Locale.ROOT, format, value.getAsDouble()) : NOTHING;
    }

    private String number(double value) {
        return String.format(Locale.ROOT, format, value).replaceAll("[^-0-9.]", "");
    }
}
