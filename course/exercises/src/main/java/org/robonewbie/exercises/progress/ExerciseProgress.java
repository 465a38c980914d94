package org.robonewbie.exercises.progress;

import java.time.Duration;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.Optional;

/**
 * How far somebody is with one exercise.
 *
 * @param tries how often a program was graded
 * @param bestPoints the best grade, 0 to 10
 * @param passed whether it was passed once
 * @param seconds time of work until it was passed first: pauses of more than 20 minutes do not count
 * @param hints how many hints are open
 * @param solutionSeen whether a solution was shown
 * @param lastSeen when something happened last, as ISO 8601; empty before
 */
public record ExerciseProgress(
        int tries, double bestPoints, boolean passed, long seconds, int hints, boolean solutionSeen, String lastSeen) {

    /** How often a program has to be graded before a solution is shown. */
    public static final int TRIES_BEFORE_SOLUTION = 3;

    /** The state of an exercise that nobody has begun. */
    public static final ExerciseProgress NONE = new ExerciseProgress(0, 0, false, 0, 0, false, "");

    private static final Duration PAUSE = Duration.ofMinutes(20);
    private static final double MOST_POINTS = 10;

    /** Puts numbers that cannot be true into their range. */
    public ExerciseProgress {
        tries = Math.max(0, tries);
        bestPoints = Double.isNaN(bestPoints) ? 0 : Math.max(0, Math.min(MOST_POINTS, bestPoints));
        seconds = Math.max(0, seconds);
        hints = Math.max(0, hints);
    }

    /**
     * Returns the state after a look at the exercise, such as its start code.
     *
     * @param now the time
     * @return the state with the time of work until now
     */
    public ExerciseProgress seen(Instant now) {
        long worked = passed ? 0 : workedUntil(now);
        return new ExerciseProgress(tries, bestPoints, passed, seconds + worked, hints, solutionSeen, now.toString());
    }

    /**
     * Returns the state after a grade.
     *
     * @param points what was earned, 0 to 10
     * @param solved whether all trials have passed
     * @param now the time
     * @return the state
     */
    public ExerciseProgress tried(double points, boolean solved, Instant now) {
        ExerciseProgress before = seen(now);
        return new ExerciseProgress(
                tries + 1,
                Math.max(bestPoints, points),
                passed || solved,
                before.seconds,
                hints,
                solutionSeen,
                before.lastSeen);
    }

    /**
     * Returns the state with one more hint.
     *
     * @param available how many there are
     * @return the state
     */
    public ExerciseProgress withNextHint(int available) {
        return new ExerciseProgress(
                tries, bestPoints, passed, seconds, Math.min(hints + 1, available), solutionSeen, lastSeen);
    }

    /** {@return the state after a solution was shown} */
    public ExerciseProgress withSolution() {
        return new ExerciseProgress(tries, bestPoints, passed, seconds, hints, true, lastSeen);
    }

    /** {@return how many graded tries are missing until a solution is shown, 0 if it may be shown} */
    public int triesBeforeSolution() {
        return passed ? 0 : Math.max(0, TRIES_BEFORE_SOLUTION - tries);
    }

    private long workedUntil(Instant now) {
        return lastSeenAt()
                .map(before -> Duration.between(before, now))
                .filter(gap -> !gap.isNegative() && gap.compareTo(PAUSE) <= 0)
                .map(Duration::toSeconds)
                .orElse(0L);
    }

    private Optional<Instant> lastSeenAt() {
        try {
            return lastSeen.isEmpty() ? Optional.empty() : Optional.of(Instant.parse(lastSeen));
        } catch (DateTimeParseException nonsense) {
            return Optional.empty();
        }
    }
}
