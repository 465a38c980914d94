package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The trials that are over. */
@FunctionalInterface
public interface Results {

    /** How trials end for a program that cannot be started. */
    Set<Ending> NEVER_STARTED = Set.of(Ending.NOT_COMPILED, Ending.REFUSED);

    /**
     * Looks up a result.
     *
     * @param trialId name of the trial
     * @return its result, or empty if it is not over
     */
    Optional<TrialResult> find(String trialId);

    /**
     * Looks whether a team could take part in any trial that is over.
     *
     * @param team name of the team
     * @param trialIds names of its trials
     * @return false if its program has never compiled, or was refused
     */
    default boolean hasCompiled(String team, List<String> trialIds) {
        List<TeamResult> over = trialIds.stream()
                .flatMap(id -> find(id).stream())
                .map(result -> result.of(team))
                .toList();
        return over.isEmpty() || over.stream().anyMatch(result -> !NEVER_STARTED.contains(result.ending()));
    }

    /**
     * Looks whether a team has played any trial to its end.
     *
     * @param team name of the team
     * @param trialIds names of its trials
     * @return false if it has lost all that are over, or none is over
     */
    default boolean hasPlayed(String team, List<String> trialIds) {
        return trialIds.stream()
                .flatMap(id -> find(id).stream())
                .anyMatch(result -> result.of(team).isPlayed());
    }
}
