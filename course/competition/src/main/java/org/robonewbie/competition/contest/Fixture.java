package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A meeting of two teams that is over.
 *
 * @param home one team
 * @param away the other team
 * @param homeGoals goals of the one
 * @param awayGoals goals of the other
 */
public record Fixture(String home, String away, int homeGoals, int awayGoals) {

    /**
     * Two teams that have to meet.
     *
     * @param home one team
     * @param away the other team
     * @param number counts the meetings from 1
     */
    record Pair(String home, String away, int number) {

        /** The second meeting, on the other team's pitch. */
        Pair again(int meeting) {
            String host = away;
            String guest = home;
            return new Pair(host, guest, meeting);
        }
    }

    /** Pairs every team with every other team once, in the order of the list. */
    static List<Pair> pairs(List<String> teams) {
        List<Pair> pairs = new ArrayList<>();
        IntStream.range(0, teams.size())
                .forEach(one -> IntStream.range(one + 1, teams.size())
                        .forEach(other -> pairs.add(new Pair(teams.get(one), teams.get(other), pairs.size() + 1))));
        return List.copyOf(pairs);
    }
}
