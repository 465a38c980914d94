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
 * What a trial has shown of one team.
 *
 * @param team name of the team
 * @param ending how the trial ended for it
 * @param figures what was measured, by name; without meaning if the team has lost the trial
 */
public record TeamResult(String team, Ending ending, SortedMap<String, Double> figures) {

    private static final String EXIT_CODE = "exitCode";
    private static final Map<String, String> UNITS = Map.of("Metres", " m", "Seconds", " s", "Degrees", "°");

    /** Makes the map unmodifiable. */
    public TeamResult {
        figures = Collections.unmodifiableSortedMap(new TreeMap<>(figures));
    }

    /**
     * Creates a result.
     *
     * @param team name of the team
     * @param ending how the trial ended for it
     * @param figures what was measured
     * @return the result
     */
    public static TeamResult of(String team, Ending ending, Map<String, Double> figures) {
        return new TeamResult(team, ending, new TreeMap<>(figures));
    }

    /** {@return whether the team took part to the end, so that its figures count} */
    public boolean isPlayed() {
        return ending == Ending.PLAYED;
    }

    /**
     * Reads a figure.
     *
     * @param name its name
     * @return its value, or empty if it was not reached or the trial is lost
     */
    public OptionalDouble figure(String name) {
        Double value = figures.get(name);
        return value == null || !isPlayed() ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    /**
     * Notes how a program has ended that ended by itself.
     *
     * @param exitCode the exit code of its process; empty if that is not known
     * @return a changed copy; the same if the program has not ended by itself
     */
    public TeamResult withExitCode(OptionalInt exitCode) {
        if (ending != Ending.STOPPED || exitCode.isEmpty()) {
            return this;
        }
        SortedMap<String, Double> more = new TreeMap<>(figures);
        more.put(EXIT_CODE, (double) exitCode.getAsInt());
        return new TeamResult(team, ending, more);
    }

    /** {@return how the trial ended for the team, with the exit code of a program that has ended by itself} */
    public String endingInWords() {
        Double exitCode = figures.get(EXIT_CODE);
        return ending.sentence() + (exitCode == null || isPlayed() ? "" : " (exit code " + exitCode.intValue() + ")");
    }

    /** {@return what the team has reached, or why it has lost the trial, for people} */
    public String inWords() {
        String measured = figures.entrySet().stream()
                .map(figure -> inWords(figure.getKey(), figure.getValue()))
                .collect(Collectors.joining(", "));
        return team + ": " + (isPlayed() && !measured.isEmpty() ? measured : endingInWords());
    }

    /** A figure is named for what it is and its unit: {@code wayMetres} becomes {@code way 3 m}. */
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
