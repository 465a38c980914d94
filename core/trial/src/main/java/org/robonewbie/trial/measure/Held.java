package org.robonewbie.trial.measure;

import java.util.function.Predicate;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.Moment;

/**
 * When something has been true for a while without a break, in seconds since the first moment that it has seen; the
 * seconds so far until then.
 *
 * <pre>{@code
 * Measure up = new Held(1, moment -> moment.robot().isStanding());
 * }</pre>
 */
public final class Held implements Measure {

    private final double seconds;
    private final Predicate<Moment> condition;
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
    public Held(double seconds, Predicate<Moment> condition) {
        this.seconds = seconds;
        this.condition = condition;
    }

    @Override
    public void see(Moment moment) {
        if (reached) {
            return;
        }
        first = Double.isNaN(first) ? moment.seconds() : first;
        now = moment.seconds() - first;
        if (!condition.test(moment)) {
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
