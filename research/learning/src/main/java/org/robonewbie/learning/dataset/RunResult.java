package org.robonewbie.learning.dataset;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Result of a run, a row of the table of runs.
 *
 * @param run the number of the run, starting from 1
 * @param seed the seed of the run
 * @param cycles the length of the run in cycles; 0 if it failed and has no tables
 * @param rows the number of rows in its table of cycles
 * @param scoreLeft the goals of the left team
 * @param scoreRight the goals of the right team
 * @param failure why the agent failed, as a sentence; empty if it did not fail
 */
public record RunResult(int run, long seed, long cycles, long rows, int scoreLeft, int scoreRight, String failure) {

    private static final String COMPLETE = "complete";
    private static final Pattern LINE = Pattern.compile(
            "(\\d{1,9}) (-?\\d{1,19}) (\\d{1,18}) (\\d{1,18}) (\\d{1,9}) (\\d{1,9}) " + COMPLETE + "(?: (.*))?");

    /** Normalises the white space in the failure sentence. */
    public RunResult {
        failure = failure.replaceAll("\\s+", " ").strip();
    }

    /**
     * Creates the result of a run without tables.
     *
     * @param run the number of the run
     * @param seed the seed of the run
     * @param failure the reason, as a sentence
     * @return the result
     */
    public static RunResult failed(int run, long seed, String failure) {
        return new RunResult(run, seed, 0, 0, 0, 0, failure);
    }

    /**
     * Returns a copy for a run that has tables although its agent failed.
     *
     * @param newFailure the reason, as a sentence
     * @return the result
     */
    public RunResult withFailure(String newFailure) {
        return new RunResult(run, seed, cycles, rows, scoreLeft, scoreRight, newFailure);
    }

    /** {@return whether the run was completed and has tables} */
    public boolean hasTables() {
        return cycles > 0;
    }

    /** {@return the result as a line of text for {@link #read}} */
    public String line() {
        return Stream.of(run, seed, cycles, rows, scoreLeft, scoreRight, COMPLETE, failure)
                .map(String::valueOf)
                .collect(Collectors.joining(" "))
                .strip();
    }

    /**
     * Parses a line of text.
     *
     * @param line the text
     * @return the result; empty if the line is incomplete
     */
    public static Optional<RunResult> read(String line) {
        Matcher found = LINE.matcher(line);
        return found.matches()
                ? Optional.of(new RunResult(
                        Integer.parseInt(found.group(1)),
                        Long.parseLong(found.group(2)),
                        Long.parseLong(found.group(3)),
                        Long.parseLong(found.group(4)),
                        Integer.parseInt(found.group(5)),
                        Integer.parseInt(found.group(6)),
                        Objects.requireNonNullElse(found.group(7), "")))
                : Optional.empty();
    }

    static List<Column> columns() {
        return List.of(
                Column.whole("run", "", "number of the run, from 1"),
                Column.whole("seed", "", "seed of the run"),
                Column.whole("cycles", "", "length of the run in cycles of 20 ms; 0 if it failed and has no tables"),
                Column.whole("rows", "", "rows in the table of cycles"),
                Column.whole("score_left", "goals", "final score of the left team"),
                Column.whole("score_right", "goals", "final score of the right team"),
                Column.text("failure", "why the agent failed; empty if it did not fail"));
    }

    List<Object> row() {
        return List.of((long) run, seed, cycles, rows, (long) scoreLeft, (long) scoreRight, failure);
    }
}
