package org.robonewbie.learning.series;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;

/** Collects what trials measure, for those who want all of it or nothing. */
public final class CollectedTrials implements TrialSink {

    private final Map<Integer, double[]> measured = new ConcurrentHashMap<>();

    /** Creates an empty collection. */
    public CollectedTrials() {}

    @Override
    public void measured(PlannedTrial trial, double[] numbers) {
        measured.put(trial.number(), numbers);
    }

    @Override
    public void failed(PlannedTrial trial, String why) {
        throw new IllegalStateException(why);
    }

    /**
     * Returns what was measured.
     *
     * @param trials trials that have all been measured
     * @return the numbers of each, in the same order
     */
    public List<double[]> of(List<PlannedTrial> trials) {
        return trials.stream()
                .map(trial -> Objects.requireNonNull(measured.get(trial.number())))
                .toList();
    }
}
