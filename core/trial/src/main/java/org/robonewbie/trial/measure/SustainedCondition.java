package org.robonewbie.trial.measure;

import java.util.function.Predicate;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.WorldState;

/**
 * When something has been true for a while without a break, in seconds since the first moment that it has seen; the
 * seconds so far until then.
 *
 * <pre>{@code
 * Measure up = new SustainedCondition(1, moment -> moment.robot().isStanding());
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
     * Creates a measure that has not seen anything.
     *
     * @param seconds how long it has to be true
     * @param condition what has to be true
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
