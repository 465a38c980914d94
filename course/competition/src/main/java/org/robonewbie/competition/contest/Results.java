package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Results of the finished trials. */
@FunctionalInterface
public interface Results {

    /** Outcomes for programs that could not be started at all. */
    Set<Ending> NEVER_STARTED = Set.of(Ending.NOT_COMPILED, Ending.REFUSED);

    /**
     * Finds the result of a trial.
     *
     * @param trialId name of the trial
     * @return the result; empty if the trial is not finished
     */
    Optional<TrialResult> find(String trialId);

    /**
     * Returns whether a team could take part in any finished trial.
     *
     * @param team name of the team
     * @param trialIds names of its trials
     * @return false if, in every finished trial, its program did not compile or was refused
     */
    default boolean hasCompiled(String team, List<String> trialIds) {
        List<TeamResult> over = trialIds.stream()
                .flatMap(id -> find(id).stream())
                .map(result -> result.of(team))
                .toList();
        return over.isEmpty() || over.stream().anyMatch(result -> !NEVER_STARTED.contains(result.ending()));
    }

    /**
     * Returns whether a team played any trial to the end.
     *
     * @param team name of the team
     * @param trialIds names of its trials
     * @return false if it forfeited all finished trials, or none has finished
     */
    default boolean hasPlayed(String team, List<String> trialIds) {
        return trialIds.stream()
                .flatMap(id -> find(id).stream())
                .anyMatch(result -> result.of(team).isPlayed());
    }
}
