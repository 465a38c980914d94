package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Result of a fixture between two teams.
 *
 * @param home home team
 * @param away away team
 * @param homeGoals goals of the home team
 * @param awayGoals goals of the away team
 */
public record Fixture(String home, String away, int homeGoals, int awayGoals) {

    /**
     * Pairing of two teams.
     *
     * @param home home team
     * @param away away team
     * @param number number of the fixture, starting at 1
     */
    record Pair(String home, String away, int number) {

        /** Returns the return match, with home and away swapped. */
        Pair again(int meeting) {
            String host = away;
            String guest = home;
            return new Pair(host, guest, meeting);
        }
    }

    /**
     * Returns the pairs of a single round robin: the first team with each later team, then the second one, and so on.
     */
    static List<Pair> pairs(List<String> teams) {
        List<Pair> pairs = new ArrayList<>();
        IntStream.range(0, teams.size())
                .forEach(one -> IntStream.range(one + 1, teams.size())
                        .forEach(other -> pairs.add(new Pair(teams.get(one), teams.get(other), pairs.size() + 1))));
        return List.copyOf(pairs);
    }
}
