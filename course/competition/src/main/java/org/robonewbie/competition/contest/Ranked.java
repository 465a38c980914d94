package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Entry of a ranking. Tied items share a rank, and the following ranks are skipped: 1, 2, 2, 4.
 *
 * @param rank rank, where 1 is the best
 * @param who the ranked item
 * @param <T> type of the items
 */
public record Ranked<T>(int rank, T who) {

    /**
     * Ranks items.
     *
     * @param candidates the items; ties keep their order
     * @param order comparator with the best first; equal items share a rank
     * @param <T> type of the items
     * @return the ranking, best first
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
