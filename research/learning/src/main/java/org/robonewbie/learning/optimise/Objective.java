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
 * What is to become better: any {@link Measure}.
 *
 * <pre>{@code
 * Objective speed = Objective.named("walk-speed", getClass().getClassLoader());
 * }</pre>
 *
 * @param label its name on the command line, such as {@code walk-speed}
 * @param measure creates the measure of each trial
 */
public record Objective(String label, Supplier<Measure> measure) {

    /**
     * Looks up an objective.
     *
     * @param label the name of a measure or of a class, as for {@link Measures#named}
     * @param classes where to look for the class
     * @return the objective
     * @throws IllegalArgumentException if there is none of this name; the message lists all
     */
    public static Objective named(String label, ClassLoader classes) {
        return new Objective(label, Measures.named(label, classes));
    }

    /** {@return the names of the framework's measures, separated by commas} */
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

    /** {@return whether it can be improved by doing something else or nothing at all} */
    boolean temptsToDoLess() {
        Measure one = measure.get();
        return one instanceof Energy || one instanceof Upright;
    }

    boolean needsBall() {
        return measure.get() instanceof KickDistance || isTimeToScore();
    }

    boolean isTimeToScore() {
        return measure.get() instanceof TimeToScore;
    }

    /** {@return whether a trial succeeds when the measure is decided; with all others it succeeds without a fall} */
    boolean isTimeToReachSomething() {
        return measure.get() instanceof SustainedCondition || isTimeToScore();
    }
}
