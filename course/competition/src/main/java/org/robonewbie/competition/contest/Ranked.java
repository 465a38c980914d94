package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * A place in a ranking. Equally good ones share a place, and the next place is counted as if they had not: 1, 2, 2, 4.
 *
 * @param rank 1 is the best
 * @param who who has this place
 * @param <T> what is ranked
 */
public record Ranked<T>(int rank, T who) {

    /**
     * Ranks.
     *
     * @param candidates who is ranked; among equals their order stays
     * @param order the better ones first; equal means the same place
     * @param <T> what is ranked
     * @return the places, the best first
     */
    public static <T> List<Ranked<T>> ranking(List<T> candidates, Comparator<T> order) {
        List<T> sorted = candidates.stream().sorted(order).toList();
        List<Ranked<T>> places = new ArrayList<>();
        for (int i = 0; i < sorted.size(); i++) {
            boolean shared = i > 0 && order.compare(sorted.get(i - 1), sorted.get(i)) == 0;
            places.add(new Ranked<>(shared ? places.get(i - 1).rank() : i + 1, sorted.get(i)));
        }
        return List.copyOf(places);
    }
}
