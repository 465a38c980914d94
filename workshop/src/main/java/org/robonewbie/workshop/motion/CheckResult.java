package org.robonewbie.workshop.motion;

import java.util.Arrays;
import java.util.List;
import java.util.stream.LongStream;

/**
 * The answer to a check.
 *
 * @param check the question
 * @param outcomes one for each trial
 */
public record CheckResult(MotionCheck check, List<Outcome> outcomes) {

    /** Makes the list unmodifiable. */
    public CheckResult {
        outcomes = List.copyOf(outcomes);
    }

    /**
     * Carries out trials, several at a time.
     *
     * @param check the question
     * @param wanted how many; a thorough check makes more of them
     * @return the answer, the same each time
     */
    public static CheckResult of(MotionCheck check, int wanted) {
        return of(check, 0, wanted);
    }

    /**
     * Carries out trials from some seed on, several at a time.
     *
     * @param check the question
     * @param firstSeed the seed of the first trial
     * @param wanted how many; a thorough check makes more of them
     * @return the answer, the same each time
     */
    public static CheckResult of(MotionCheck check, long firstSeed, int wanted) {
        long trials = Math.round(check.thoroughness() * wanted);
        Outcome[] outcomes = LongStream.range(firstSeed, firstSeed + trials)
                .parallel()
                .mapToObj(check.trial())
                .toArray(Outcome[]::new);
        return new CheckResult(check, Arrays.asList(outcomes));
    }

    /** {@return how many trials succeeded} */
    public int successes() {
        return (int) outcomes.stream().filter(Outcome::success).count();
    }

    /**
     * Averages what was measured.
     *
     * @return the mean over the successful trials, in the unit of the check; 0 if there are none
     */
    public double mean() {
        return outcomes.stream()
                .filter(Outcome::success)
                .mapToDouble(Outcome::value)
                .average()
                .orElse(0);
    }
}
