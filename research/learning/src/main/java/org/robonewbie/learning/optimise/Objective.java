package org.robonewbie.learning.optimise;

import java.util.function.Supplier;
import org.robonewbie.trial.Measure;
import org.robonewbie.trial.measure.Energy;
import org.robonewbie.trial.measure.KickDistance;
import org.robonewbie.trial.measure.Measures;
import org.robonewbie.trial.measure.SustainedCondition;
import org.robonewbie.trial.measure.TimeToScore;
import org.robonewbie.trial.measure.Upright;

/**
 * Objective of an optimisation: any {@link Measure}.
 *
 * <pre>{@code
 * Objective speed = Objective.named("walk-speed", getClass().getClassLoader());
 * }</pre>
 *
 * @param label the name on the command line, such as {@code walk-speed}
 * @param measure creates the measure of a trial
 */
public record Objective(String label, Supplier<Measure> measure) {

    /**
     * Looks up an objective.
     *
     * @param label the name of a measure or of a class, as for {@link Measures#named}
     * @param classes the class loader for custom measures
     * @return the objective
     * @throws IllegalArgumentException if there is no such measure; the message lists all measures
     */
    public static Objective named(String label, ClassLoader classes) {
        return new Objective(label, Measures.named(label, classes));
    }

    /** {@return the names of the built-in measures, separated by commas} */
    public static String labels() {
        return Measures.names();
    }

    /** {@return the unit of the value, such as {@code m/s}} */
    public String unit() {
        return measure.get().unit();
    }

    /** {@return whether larger values are better} */
    public boolean isLargerBetter() {
        return measure.get().isLargerBetter();
    }

    /**
     * Returns whether the value improves if the robot moves less, in which case the effect of the motion must be
     * preserved.
     */
    boolean rewardsInaction() {
        Measure one = measure.get();
        return one instanceof Energy || one instanceof Upright;
    }

    boolean needsBall() {
        return measure.get() instanceof KickDistance || isTimeToScore();
    }

    boolean isTimeToScore() {
        return measure.get() instanceof TimeToScore;
    }

    /**
     * Returns whether the measure is the time until an event. If so, a trial succeeds if the event occurs; otherwise,
     * it succeeds if there is no fall.
     */
    boolean isTimeToEvent() {
        return measure.get() instanceof SustainedCondition || isTimeToScore();
    }
}
