package org.robonewbie.competition.contest;

import java.util.List;

/**
 * Penalty shoot-out between two teams: a fixed number of rounds in which each team attacks once, followed by sudden death
 * while the score is level.
 *
 * @param rounds number of regular rounds
 * @param suddenDeathRounds maximum number of sudden-death rounds
 */
record ShootOut(int rounds, int suddenDeathRounds) {

    /** Goals of both teams in one round, each 0 or 1. */
    record Round(int home, int away) {}

    /** Returns the minimum total number of rounds, given the rounds played so far. */
    int roundsNeeded(List<Round> played) {
        if (played.size() < rounds || !isEqual(played) || played.size() >= rounds + suddenDeathRounds) {
            return Math.max(rounds, played.size());
        }
        return played.size() + 1;
    }

    /** Returns whether the shoot-out is decided. */
    boolean isOver(List<Round> played) {
        return played.size() >= roundsNeeded(played);
    }

    private static boolean isEqual(List<Round> played) {
        return played.stream().mapToInt(round -> round.home() - round.away()).sum() == 0;
    }
}
