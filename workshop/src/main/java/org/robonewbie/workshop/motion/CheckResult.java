package org.robonewbie.workshop.motion;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.LongStream;

/**
 * Result of a check.
 *
 * @param check the check
 * @param outcomes one outcome per trial
 */
public record CheckResult(MotionCheck check, List<Outcome> outcomes) {

    /** Stores an unmodifiable copy of the list. */
    public CheckResult {
        outcomes = List.copyOf(outcomes);
    }

    /**
     * Runs trials with consecutive seeds, several in parallel.
     *
     * @param check the check
     * @param firstSeed seed of the first trial
     * @param wanted base number of trials, which is multiplied by the check's thoroughness
     * @return the result, which is deterministic
     */
    public static CheckResult of(MotionCheck check, long firstSeed, int wanted) {
        long trials = Math.round(check.thoroughness() * wanted);
        Outcome[] outcomes = LongStream.range(firstSeed, firstSeed + trials)
                .parallel()
                .mapToObj(check.trial())
                .toArray(Outcome[]::new);
        return new CheckResult(check, Arrays.asList(outcomes));
    }

    /** {@return the number of successful trials} */
    public int successes() {
        return (int) outcomes.stream().filter(Outcome::success).count();
    }

    /** {@return the mean over the successful trials in the unit of the check; 0 if there are none} */
    public double mean() {
        return outcomes.stream()
                .filter(Outcome::success)
                .mapToDouble(Outcome::value)
                .average()
                .orElse(0);
    }

    /**
     * Formats results as a Markdown table.
     *
     * @param results the results
     * @return the table, ending with a line break
     */
    public static String table(List<CheckResult> results) {
        return results.stream()
                .map(CheckResult::toRow)
                .collect(Collectors.joining("", "| motion | success is | trials | mean |\n|---|---|---|---|\n", ""));
    }

    /**
     * Returns the cells that do not depend on a measurement.
     *
     * @param check the check
     * @return the first cells of its row in the {@linkplain #table table}
     */
    public static String startOfRow(MotionCheck check) {
        return "| " + check.name() + " | " + check.rule() + " | ";
    }

    private String toRow() {
        return String.format(
                Locale.ROOT,
                "%s%d of %d | %.3f %s |\n",
                startOfRow(check),
                successes(),
                outcomes.size(),
                mean(),
                check.unit());
    }
}
