package org.robonewbie.workshop.load;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Cost of one example.
 *
 * @param name name of the example
 * @param robots number of its robots
 * @param cycles number of measured cycles of all robots
 * @param usualMilliseconds median of the processor time from a message to the reply
 * @param slowMilliseconds 99th percentile of this time
 * @param worstMilliseconds maximum of this time
 * @param missedCycles number of messages whose reply was sent after the next message had arrived
 */
record ExampleLoadResult(
        String name,
        int robots,
        int cycles,
        double usualMilliseconds,
        double slowMilliseconds,
        double worstMilliseconds,
        int missedCycles) {

    /** Header of the Markdown table of {@link #toRow rows}. */
    static final String TITLE = """
            | example | robots | median, ms | 99 % of cycles, ms | longest, ms | missed cycles |
            |---|---|---|---|---|---|
            """;

    static ExampleLoadResult of(String name, List<ThinkTimes> robots) {
        long[] sorted = robots.stream()
                .flatMapToLong(robot -> Arrays.stream(robot.nanoseconds()))
                .sorted()
                .toArray();
        return new ExampleLoadResult(
                name,
                robots.size(),
                sorted.length,
                milliseconds(sorted, 0.5),
                milliseconds(sorted, 0.99),
                milliseconds(sorted, 1),
                robots.stream().mapToInt(ThinkTimes::missedCycles).sum());
    }

    private static double milliseconds(long[] sorted, double share) {
        return sorted.length == 0 ? Double.NaN : sorted[(int) Math.ceil(share * sorted.length) - 1] / 1e6;
    }

    String toRow() {
        return String.format(
                Locale.ROOT,
                "| `%s` | %d | %.3f | %.3f | %.2f | %d of %d |",
                name,
                robots,
                usualMilliseconds,
                slowMilliseconds,
                worstMilliseconds,
                missedCycles,
                cycles);
    }
}
