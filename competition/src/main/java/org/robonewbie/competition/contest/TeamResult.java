package org.robonewbie.competition.contest;

import java.util.Collections;
import java.util.Map;
import java.util.OptionalDouble;
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

    /** {@return what the team has reached, or why it has lost the trial, for people} */
    public String inWords() {
        String measured = figures.entrySet().stream()
                .map(figure -> figure.getKey() + " " + Math.round(figure.getValue() * 100) / 100.0)
                .collect(Collectors.joining(", "));
        return team + " " + (isPlayed() && !measured.isEmpty() ? measured : ending.sentence());
    }
}
