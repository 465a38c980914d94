package org.robonewbie.learning.optimise;

/**
 * What one generation of an optimisation has reached.
 *
 * @param number from 1
 * @param of how many there will be
 * @param score how its candidates did
 * @param distribution of the candidates of the next generation
 * @param pace how fast the search is; {@link Pace#UNKNOWN} for a generation from before an interruption
 */
public record Generation(int number, int of, Score score, SearchDistribution distribution, Pace pace) {

    /**
     * How the candidates of a generation did.
     *
     * @param best the value of the best candidate, in the unit of the objective
     * @param mean the mean value of all candidates
     * @param success share of all trials that ended as they should, 0 to 1
     */
    public record Score(double best, double mean, double success) {}

    /**
     * How fast a search is.
     *
     * @param trialsPerSecond trials in each second of the clock, 0 if unknown
     * @param secondsLeft how long the rest will take, estimated from this run
     */
    public record Pace(double trialsPerSecond, double secondsLeft) {

        /** The pace of what was done in an earlier run. */
        public static final Pace UNKNOWN = new Pace(0, 0);
    }

    /** {@return whether this generation comes from the checkpoint, since it was tried before an interruption} */
    public boolean isRemembered() {
        return pace.equals(Pace.UNKNOWN);
    }
}
