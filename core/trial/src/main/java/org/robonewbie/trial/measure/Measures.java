package org.robonewbie.trial.measure;

import java.util.Map;
import java.util.function.Supplier;
import org.robonewbie.trial.Measure;

/**
 * A registry of measures. It finds the framework's measures and your own classes by name.
 *
 * <pre>{@code
 * Supplier<Measure> speed = Measures.named("walk-speed", getClass().getClassLoader());
 * }</pre>
 */
public final class Measures {

    private static final Map<String, Supplier<Measure>> ALL = Map.of(
            "distance-walked", Distance::new,
            "walk-speed", Speed::new,
            "energy", Energy::new,
            "stability", Upright::new,
            "standing-time", Standing::new,
            "get-up-time", Measures::getUp,
            "kick-distance", KickDistance::new,
            "time-to-score", TimeToScore::new);

    private static final Catalogue<Measure> CATALOGUE = new Catalogue<>("measure", Measure.class, ALL);

    private Measures() {}

    /**
     * Looks up a measure.
     *
     * @param name a name such as {@code walk-speed}, or the name of a class that implements {@link Measure} and has a public
     *     no-arg constructor
     * @param classes the class loader
     * @return a factory that creates a measure for each trial
     * @throws IllegalArgumentException if there is no such measure; the message lists all names
     */
    public static Supplier<Measure> named(String name, ClassLoader classes) {
        return CATALOGUE.named(name, classes);
    }

    /** {@return the names of the framework's measures, separated by commas} */
    public static String names() {
        return CATALOGUE.names();
    }

    private static Measure getUp() {
        return new SustainedCondition(1, state -> state.robot().isStanding());
    }
}
