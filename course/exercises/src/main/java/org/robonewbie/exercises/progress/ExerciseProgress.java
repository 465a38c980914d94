package org.robonewbie.exercises.progress;

import java.time.Instant;

/**
 * A student's progress on one exercise.
 *
 * @param tries number of graded tries
 * @param bestPoints points scored in the best try, 0 to 10
 * @param passed whether the exercise has been passed
 * @param seconds working time in seconds until the exercise was passed; pauses of more than 20 minutes do not count
 * @param hints number of hints opened
 * @param solutionSeen whether a solution has been shown
 * @param lastSeen time of the last activity in ISO 8601 format; empty before the first activity
 */
public record ExerciseProgress(
        int tries, double bestPoints, boolean passed, long seconds, int hints, boolean solutionSeen, String lastSeen) {

    /** Number of graded tries required before a solution is shown. */
    public static final int TRIES_BEFORE_SOLUTION = 3;

    /** Progress before the first activity. */
    public static final ExerciseProgress NONE = new ExerciseProgress(0, 0, false, 0, 0, false, "");

    private static final long MAX_PAUSE_MILLIS = 20 * 60_000;
    private static final long MILLIS_PER_SECOND = 1000;
    private static final double MAX_POINTS = 10;

    /** Clamps all numbers to their valid ranges. */
    public ExerciseProgress {
        tries = Math.max(0, tries);
        bestPoints = Double.isNaN(bestPoints) ? 0 : Math.max(0, Math.min(MAX_POINTS, bestPoints));
        seconds = Math.max(0, seconds);
        hints = Math.max(0, hints);
    }

    /**
     * Adds the time since the last activity to the working time.
     *
     * @param now the current time
     * @return the new state
     */
    public ExerciseProgress seen(Instant now) {
        long worked = passed ? 0 : workedUntil(now);
        return new ExerciseProgress(tries, bestPoints, passed, seconds + worked, hints, solutionSeen, now.toString());
    }

    /**
     * Adds a graded try.
     *
     * @param points points scored in the try, 0 to 10
     * @param solved whether all trials have passed
     * @param now the current time
     * @return the new state
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
     * Counts one more hint as opened.
     *
     * @param available total number of hints
     * @return the new state
     */
    public ExerciseProgress withNextHint(int available) {
        return new ExerciseProgress(
                tries, bestPoints, passed, seconds, Math.min(hints + 1, available), solutionSeen, lastSeen);
    }

    /** {@return the state after a solution has been shown} */
    public ExerciseProgress withSolution() {
        return new ExerciseProgress(tries, bestPoints, passed, seconds, hints, true, lastSeen);
    }

    /** {@return the number of graded tries that are still required before a solution is shown, 0 if none} */
    public int triesBeforeSolution() {
        return passed ? 0 : Math.max(0, TRIES_BEFORE_SOLUTION - tries);
    }

    private long workedUntil(Instant now) {
        try {
            long gap = lastSeen.isEmpty()
                    ? 0
                    : now.toEpochMilli() - Instant.parse(lastSeen).toEpochMilli();
            return gap >= 0 && gap <= MAX_PAUSE_MILLIS ? gap / MILLIS_PER_SECOND : 0;
        } catch (RuntimeException noTime) {
            return 0;
        }
    }
}
