package org.robonewbie.trial;

/**
 * A measurement of one quantity in a trial, such as the distance that a robot has walked. It observes the true state
 * after each cycle. Measures are stateful, so each trial needs new ones.
 *
 * <pre>{@code
 * public final class Height implements Measure {
 *     private double metres;
 *     public void see(WorldState state) { metres = Math.max(metres, state.robot().position().z()); }
 *     public double value() { return metres; }
 * }
 * }</pre>
 *
 * <p>Ready-made measures are in {@link org.robonewbie.trial.measure}.
 */
public interface Measure {

    /**
     * Observes the true state after a cycle. The first state is the start of the trial.
     *
     * @param state the true state
     */
    void see(WorldState state);

    /** {@return the value so far in {@link #unit}; never NaN} */
    double value();

    /** {@return the unit of the value, such as {@code m/s}; empty for a dimensionless number} */
    default String unit() {
        return "";
    }

    /** {@return whether larger values are better} */
    default boolean isLargerBetter() {
        return true;
    }

    /** {@return whether the value is final, so that the trial may end early} */
    default boolean isDecided() {
        return false;
    }
}
