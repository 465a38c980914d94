package org.robonewbie.agent.running;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Notices that many cycles of a robot's program take long, and what takes the time: a few samples of its stack in each of them. A single
 * pause, such as one in a debugger, the first cycle of Java or a collection of garbage, does not count.
 */
final class SlowCycles {

    /** Slow thoughts count together if they are among this many that follow each other. */
    private static final int THOUGHTS = 50;

    private static final int WAITING_TO_REPORT = 3;
    private static final int COMPUTING_TO_REPORT = 5;
    private static final double COMPUTING_MILLISECONDS = 50;

    private final Deque<SlowThought> slow = new ArrayDeque<>();
    private final Map<StackSample, Integer> samples = new HashMap<>();
    private long thought;
    private double computedMilliseconds;

    private record SlowThought(long number, double milliseconds, StackSample cause) {

        /** Time that is computed is spent in many lines, which belong together. */
        boolean isLike(SlowThought other) {
            boolean computes = cause.kind() == StackSample.Kind.COMPUTES;
            return computes ? other.cause.kind() == cause.kind() : other.cause.equals(cause);
        }
    }

    /** Notes what the program does at this moment, and how long a processor has worked for it since the last sample. */
    synchronized void sample(StackSample sample, double workedMilliseconds) {
        samples.merge(sample, 1, Integer::sum);
        computedMilliseconds += workedMilliseconds;
    }

    /**
     * Ends a thought.
     *
     * @param milliseconds how long it has taken
     * @return what makes the program slow, if thoughts like this one have become many
     */
    synchronized Optional<Slowness> thoughtEnds(double milliseconds) {
        thought++;
        if (samples.isEmpty()) {
            return Optional.empty();
        }
        SlowThought last = new SlowThought(thought, milliseconds, mainCause());
        boolean counts =
                last.cause().kind() != StackSample.Kind.COMPUTES || computedMilliseconds >= COMPUTING_MILLISECONDS;
        samples.clear();
        computedMilliseconds = 0;
        return counts && !last.cause().place().isEmpty() ? judge(last) : Optional.empty();
    }

    /** The kind with most samples, and of these the line with most. */
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

    private Optional<Slowness> judge(SlowThought last) {
        slow.removeIf(each -> each.number() <= thought - THOUGHTS);
        slow.addLast(last);
        List<SlowThought> alike = slow.stream().filter(last::isLike).toList();
        boolean computes = last.cause().kind() == StackSample.Kind.COMPUTES;
        if (alike.size() < (computes ? COMPUTING_TO_REPORT : WAITING_TO_REPORT)) {
            return Optional.empty();
        }
        slow.removeIf(last::isLike);
        Map<StackSample, Integer> causes = new HashMap<>();
        alike.forEach(each -> causes.merge(each.cause(), 1, Integer::sum));
        return Optional.of(new Slowness(mostFrequent(causes, !computes), median(alike)));
    }

    private static double median(List<SlowThought> thoughts) {
        return thoughts.stream()
                .mapToDouble(SlowThought::milliseconds)
                .sorted()
                .skip(thoughts.size() / 2)
                .findFirst()
                .orElseThrow();
    }
}
