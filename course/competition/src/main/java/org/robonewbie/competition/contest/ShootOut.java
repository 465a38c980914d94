package org.robonewbie.competition.contest;

import java.util.List;

/**
 * A penalty shoot-out of two teams: some rounds in which each of them attacks once, then, while they are equal, further rounds one
 * by one.
 *
 * @param rounds rounds that are played in any case
 * @param suddenDeathRounds rounds that are added at most
 */
record ShootOut(int rounds, int suddenDeathRounds) {

    /** What both teams did in one round: goals are 1 or 0. */
    record Round(int home, int away) {}

    /** The number of rounds that are needed, as known from the ones played. */
    int roundsNeeded(List<Round> played) {
        if (played.size() < rounds || !isEqual(played) || played.size() >= rounds + suddenDeathRounds) {
            return Math.max(rounds, played.size());
        }
        return played.size() + 1;
    }

    /** Whether the shoot-out is decided. */
    boolean isOver(List<Round> played) {
        return played.size() >= roundsNeeded(played);
    }

    private static boolean isEqual(List<Round> played) {
        return played.stream().mapToInt(round -> round.home() - round.away()).sum() == 0;
    }
}
