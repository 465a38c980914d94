package org.robonewbie.agent.running;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Detects programs that are slow in many cycles and determines the cause, from a few stack samples per slow cycle. A
 * single pause, such as a breakpoint, class loading in the first cycle or garbage collection, does not count.
 */
final class SlowCycles {

    /** Window, in cycles, within which slow cycles are counted together. */
    private static final int WINDOW_CYCLES = 50;

    private static final int WAITING_TO_REPORT = 3;
    private static final int COMPUTING_TO_REPORT = 5;
    private static final double COMPUTING_MILLISECONDS = 50;

    private final Deque<SlowCycle> slow = new ArrayDeque<>();
    private final Map<StackSample, Integer> samples = new HashMap<>();
    private long cycle;
    private double computedMilliseconds;

    private record SlowCycle(long number, double milliseconds, StackSample cause) {

        /**
         * Returns whether two slow cycles have the same cause. All cycles spent computing count as having the same
         * cause, because computation is spread over many lines.
         */
        boolean isLike(SlowCycle other) {
            boolean computes = cause.kind() == StackSample.Kind.COMPUTES;
            return computes ? other.cause.kind() == cause.kind() : other.cause.equals(cause);
        }
    }

    /** Adds a sample with the processor time used since the previous one. */
    synchronized void sample(StackSample sample, double workedMilliseconds) {
        samples.merge(sample, 1, Integer::sum);
        computedMilliseconds += workedMilliseconds;
    }

    /**
     * Ends a cycle.
     *
     * @param milliseconds its duration
     * @return the cause, once many cycles have been slow
     */
    synchronized Optional<Slowness> cycleEnds(double milliseconds) {
        cycle++;
        if (samples.isEmpty()) {
            return Optional.empty();
        }
        SlowCycle last = new SlowCycle(cycle, milliseconds, mainCause());
        boolean counts =
                last.cause().kind() != StackSample.Kind.COMPUTES || computedMilliseconds >= COMPUTING_MILLISECONDS;
        samples.clear();
        computedMilliseconds = 0;
        return counts && !last.cause().place().isEmpty() ? judge(last) : Optional.empty();
    }

    /** Returns the most frequent sample of the most frequent kind. */
    private StackSample mainCause() {
        long waiting = samples.entrySet().stream()
                .filter(each -> each.getKey().kind() != StackSample.Kind.COMPUTES)
                .mapToLong(Map.Entry::getValue)
                .sum();
        long all = samples.values().stream().mapToLong(count -> count).sum();
        boolean waits = 2 * waiting >= all;
        return mostFrequent(samples, waits);
    }

    private static StackSample mostFrequent(Map<StackSample, Integer> samples, boolean waits) {
        return samples.entrySet().stream()
                .filter(each -> (each.getKey().kind() != StackSample.Kind.COMPUTES) == waits)
                .max(Map.Entry.comparingByValue())
                .orElseThrow()
                .getKey();
    }

    private Optional<Slowness> judge(SlowCycle last) {
        slow.removeIf(each -> each.number() <= cycle - WINDOW_CYCLES);
        slow.addLast(last);
        List<SlowCycle> alike = slow.stream().filter(last::isLike).toList();
        boolean computes = last.cause().kind() == StackSample.Kind.COMPUTES;
        if (alike.size() < (computes ? COMPUTING_TO_REPORT : WAITING_TO_REPORT)) {
            return Optional.empty();
        }
        slow.removeIf(last::isLike);
        Map<StackSample, Integer> causes = new HashMap<>();
        alike.forEach(each -> causes.merge(each.cause(), 1, Integer::sum));
        return Optional.of(new Slowness(mostFrequent(causes, !computes), median(alike)));
    }

    private static double median(List<SlowCycle> cycles) {
        return cycles.stream()
                .mapToDouble(SlowCycle::milliseconds)
                .sorted()
                .skip(cycles.size() / 2)
                .findFirst()
                .orElseThrow();
    }
}
