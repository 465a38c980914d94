package org.robonewbie.competition.contest;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Result of a trial. It does not depend on the computer: repeating the trial on another computer gives the same result.
 *
 * @param id name of the trial
 * @param seed seed of all random numbers
 * @param seconds simulated seconds from the start to the decision
 * @param teams one result per participating team
 */
public record TrialResult(String id, long seed, double seconds, List<TeamResult> teams) {

    /** Creates the result. */
    public TrialResult {
        teams = List.copyOf(teams);
    }

    /**
     * Returns a team's result.
     *
     * @param name name of a participating team
     * @return the team's result
     */
    public TeamResult of(String name) {
        return teams.stream()
                .filter(result -> result.team().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** {@return the results of all teams as display text} */
    public String inWords() {
        return teams.stream().map(TeamResult::inWords).collect(Collectors.joining("; "));
    }
}
