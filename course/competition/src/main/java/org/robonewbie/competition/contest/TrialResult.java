package org.robonewbie.competition.contest;

import java.util.List;
import java.util.stream.Collectors;

/**
 * What a trial has shown. Nothing in it depends on the computer, so that the same trial gives the same result.
 *
 * @param id name of the trial
 * @param seed start of all random numbers
 * @param seconds simulated seconds from the start to the decision
 * @param teams one result for each team that took part
 */
public record TrialResult(String id, long seed, double seconds, List<TeamResult> teams) {

    /** Makes the list unmodifiable. */
    public TrialResult {
        teams = List.copyOf(teams);
    }

    /**
     * Returns a team's result.
     *
     * @param name name of a team that took part
     * @return its result
     */
    public TeamResult of(String name) {
        return teams.stream()
                .filter(result -> result.team().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** {@return what each team has reached, for people} */
    public String inWords() {
        return teams.stream().map(TeamResult::inWords).collect(Collectors.joining("; "));
    }
}
