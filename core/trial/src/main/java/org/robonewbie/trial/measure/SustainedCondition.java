package org.robonewbie.trial.measure;

import java.util.function.Predicate;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/**
 * The time in seconds from the first observed state until a condition has held without interruption for a given duration.
 * Before that, the value is the elapsed time.
 *
 * <pre>{@code
 * Measure up = new SustainedCondition(1, state -> state.robot().isStanding());
 * }</pre>
 */
public final class SustainedCondition implements Measure {

    private final double seconds;
    private final Predicate<WorldState> condition;
    private double first = Double.NaN;
    private double since = Double.NaN;
    private double now;
    private boolean reached;

    /**
     * Creates the measure.
     *
     * @param seconds duration for which the condition must hold
     * @param condition the condition
     */
    public SustainedCondition(double seconds, Predicate<WorldState> condition) {
        this.seconds = seconds;
        this.condition = condition;
    }

    @Override
    public void see(WorldState state) {
        if (reached) {
            return;
        }
        first = Double.isNaN(first) ? state.seconds() : first;
        now = state.seconds() - first;
        if (!condition.test(state)) {
            since = Double.NaN;
        } else if (Double.isNaN(since)) {
            since = now;
        } else {
            reached = now - since >= seconds;
        }
    }

    @Override
    public double value() {
        return now;
    }

    @Override
    public String unit() {
        return "s";
    }

    @Override
    public boolean isLargerBetter() {
        return false;
    }

    @Override
    public boolean isDecided() {
        return reached;
    }
}
