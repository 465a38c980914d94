package org.robonewbie.competition.contest;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Collections;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Result of a trial for one team.
 *
 * @param team name of the team
 * @param ending outcome of the trial for the team
 * @param figures measured values by name; meaningless if the team forfeited the trial
 */
public record TeamResult(String team, Ending ending, SortedMap<String, Double> figures) {

    private static final String EXIT_CODE = "exitCode";
    private static final Map<String, String> UNITS = Map.of("Metres", " m", "Seconds", " s", "Degrees", "°");

    /** Creates the result. */
    public TeamResult {
        figures = Collections.unmodifiableSortedMap(new TreeMap<>(figures));
    }

    /**
     * Creates a result.
     *
     * @param team name of the team
     * @param ending outcome of the trial for the team
     * @param figures measured values by name
     * @return the result
     */
    public static TeamResult of(String team, Ending ending, Map<String, Double> figures) {
        return new TeamResult(team, ending, new TreeMap<>(figures));
    }

    /** {@return whether the team played to the end, so that its measured values count} */
    public boolean isPlayed() {
        return ending == Ending.PLAYED;
    }

    /**
     * Returns a measured value.
     *
     * @param name name of the value
     * @return the value; empty if it was not measured or the team forfeited the trial
     */
    public OptionalDouble figure(String name) {
        Double value = figures.get(name);
        return value == null || !isPlayed() ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    /**
     * Adds the exit code of a program that exited early.
     *
     * @param exitCode exit code of its process; empty if unknown
     * @return a copy with the exit code; this result if {@code exitCode} is empty
     */
    public TeamResult withExitCode(OptionalInt exitCode) {
        if (ending != Ending.STOPPED || exitCode.isEmpty()) {
            return this;
        }
        SortedMap<String, Double> more = new TreeMap<>(figures);
        more.put(EXIT_CODE, (double) exitCode.getAsInt());
        return new TeamResult(team, ending, more);
    }

    /** {@return the outcome as display text, with the exit code of a program that exited early} */
    public String endingInWords() {
        Double exitCode = figures.get(EXIT_CODE);
        return ending.sentence() + (exitCode == null || isPlayed() ? "" : " (exit code " + exitCode.intValue() + ")");
    }

    /** {@return the measured values, or the reason why the team forfeited the trial, as display text} */
    public String inWords() {
        String measured = figures.entrySet().stream()
                .map(figure -> inWords(figure.getKey(), figure.getValue()))
                .collect(Collectors.joining(", "));
        return team + ": " + (isPlayed() && !measured.isEmpty() ? measured : endingInWords());
    }

    /**
     * Formats a value with its unit, which is the last word of the name: {@code wayMetres} with the value 3 becomes
     * {@code way 3 m}.
     */
    private static String inWords(String name, double value) {
        String number = BigDecimal.valueOf(value)
                .setScale(2, RoundingMode.HALF_UP)
                .stripTrailingZeros()
                .toPlainString();
        for (Map.Entry<String, String> unit : UNITS.entrySet()) {
            if (name.endsWith(unit.getKey())) {
                return words(name.substring(0, name.length() - unit.getKey().length())) + " " + number
                        + unit.getValue();
            }
        }
        return words(name) + " " + number;
    }

    private static String words(String name) {
        return name.replaceAll("(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }
}
