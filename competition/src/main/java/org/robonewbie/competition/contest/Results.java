package org.robonewbie.competition.contest;

import java.util.Optional;

/** The trials that are over. */
@FunctionalInterface
public interface Results {

    /**
     * Looks up a result.
     *
     * @param trialId name of the trial
     * @return its result, or empty if it is not over
     */
    Optional<TrialResult> find(String trialId);
}
