package org.robonewbie.learning.dataset;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What became of a run: a row of the table of runs.
 *
 * @param run its number, from 1
 * @param seed what chooses all that is random in it
 * @param cycles how many cycles it lasted; 0 if it has no tables, since it failed
 * @param rows how many rows its table of cycles has
 * @param scoreLeft goals of the left team
 * @param scoreRight goals of the right team
 * @param failure why the program failed, in a sentence; empty if it did not
 */
public record RunResult(int run, long seed, long cycles, long rows, int scoreLeft, int scoreRight, String failure) {

    private static final String COMPLETE = "complete";
    private static final Pattern LINE = Pattern.compile(
            "(\\d{1,9}) (-?\\d{1,19}) (\\d{1,18}) (\\d{1,18}) (\\d{1,9}) (\\d{1,9}) " + COMPLETE + "(?: (.*))?");

    /** Puts the sentence into one line. */
    public RunResult {
        failure = failure.replaceAll("\\s+", " ").strip();
    }

    /**
     * Makes the row of a run that has no tables.
     *
     * @param run its number
     * @param seed its seed
     * @param why what went wrong, as a sentence
     * @return the row
     */
    public static RunResult failed(int run, long seed, String why) {
        return new RunResult(run, seed, 0, 0, 0, 0, why);
    }

    /**
     * Adds that the program failed although the run has tables.
     *
     * @param why what went wrong, as a sentence
     * @return the row with it
     */
    public RunResult withFailure(String why) {
        return new RunResult(run, seed, cycles, rows, scoreLeft, scoreRight, why);
    }

    /** {@return whether the run lasted to its end and has tables} */
    public boolean hasTables() {
        return cycles > 0;
    }

    /** {@return the row as a line of text, which {@link #read} understands} */
    public String line() {
        return Stream.of(run, seed, cycles, rows, scoreLeft, scoreRight, COMPLETE, failure)
                .map(String::valueOf)
                .collect(Collectors.joining(" "))
                .strip();
    }

    /**
     * Reads a line.
     *
     * @param line the text
     * @return the row; empty if the line is not complete
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
                Column.whole("seed", "", "chooses all that is random in it"),
                Column.whole("cycles", "", "length of the run, each cycle 20 ms; 0 if it failed and has no tables"),
                Column.whole("rows", "", "rows in the table of cycles"),
                Column.whole("score_left", "goals", "of the left team at the end"),
                Column.whole("score_right", "goals", "of the right team at the end"),
                Column.text("failure", "why the program failed; empty if it did not"));
    }

    List<Object> row() {
        return List.of((long) run, seed, cycles, rows, (long) scoreLeft, (long) scoreRight, failure);
    }
}
