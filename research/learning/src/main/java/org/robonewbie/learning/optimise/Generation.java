package org.robonewbie.learning.optimise;

/**
 * Result of one generation of an optimisation.
 *
 * @param number the number of the generation, starting from 1
 * @param of the planned number of generations
 * @param score the score of its candidates
 * @param distribution the distribution of the next candidates
 * @param pace the speed of the search; {@link Pace#UNKNOWN} for a generation that was completed before an interruption
 */
public record Generation(int number, int of, Score score, SearchDistribution distribution, Pace pace) {

    /**
     * Score of a generation.
     *
     * @param best the value of the best candidate, in the unit of the objective
     * @param mean the mean value of all candidates
     * @param success the fraction of trials that succeeded, 0 to 1
     */
    public record Score(double best, double mean, double success) {}

    /**
     * Speed of a search.
     *
     * @param trialsPerSecond trials per second of real time, 0 if unknown
     * @param secondsLeft the estimated remaining time in seconds
     */
    public record Pace(double trialsPerSecond, double secondsLeft) {

        /** The pace of a generation that was read from the checkpoint. */
        public static final Pace UNKNOWN = new Pace(0, 0);
    }

    /** {@return whether this generation comes from the checkpoint of an interrupted search} */
    public boolean isRemembered() {
        return pace.equals(Pace.UNKNOWN);
    }
}
