package org.robonewbie.trial;

/**
 * What a trial is watched for: it sees the truth of each cycle and has a value at any time, such as the metres that a robot has
 * walked. Measures remember what they have seen, so each trial needs new ones.
 *
 * <pre>{@code
 * public final class Height implements Measure {
 *     private double metres;
 *     public void see(WorldState moment) { metres = Math.max(metres, moment.robot().position().z()); }
 *     public double value() { return metres; }
 * }
 * }</pre>
 *
 * <p>Ready-made measures are in {@link org.robonewbie.trial.measure}.
 */
public interface Measure {

    /**
     * Looks at the truth after a cycle; the first moment is the beginning of the trial.
     *
     * @param state what is true now
     */
    void see(WorldState state);

    /** {@return what has been measured so far, in the measure's unit; always a number} */
    double value();

    /** {@return the unit of the value, such as {@code m/s}; empty for a mere number} */
    default String unit() {
        return "";
    }

    /** {@return whether a larger value is better than a smaller one} */
    default boolean isLargerBetter() {
        return true;
    }

    /** {@return whether there is nothing more to see, so that the trial may end before its time} */
    default boolean isDecided() {
        return false;
    }
}
