package org.robonewbie.trial.measure;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.robonewbie.trial.Measure;

/**
 * Finds measures by name: those of the framework, and classes of your own.
 *
 * <pre>{@code
 * Supplier<Measure> speed = Measures.named("walk-speed", getClass().getClassLoader());
 * }</pre>
 */
public final class Measures {

    private static final Map<String, Supplier<Measure>> ALL = new TreeMap<>(Map.of(
            "distance-walked", Distance::new,
            "walk-speed", Speed::new,
            "energy", Energy::new,
            "stability", Upright::new,
            "standing-time", Standing::new,
            "get-up-time", Measures::getUp,
            "kick-distance", KickDistance::new,
            "time-to-score", TimeToScore::new));

    private Measures() {}

    /**
     * Looks up a measure.
     *
     * @param name a name such as {@code walk-speed}, or the name of a class that implements {@link Measure} and has a public
     *     constructor without parameters
     * @param classes where to look for the class
     * @return creates a new measure for each trial
     * @throws IllegalArgumentException if there is none of this name; the message lists all
     */
    public static Supplier<Measure> named(String name, ClassLoader classes) {
        Supplier<Measure> known = ALL.get(name);
        return known == null ? ofClass(name, classes) : known;
    }

    /** {@return the names of the framework's measures, separated by commas} */
    public static String names() {
        return String.join(", ", ALL.keySet());
    }

    private static Supplier<Measure> ofClass(String name, ClassLoader classes) {
        try {
            Class<? extends Measure> type = Class.forName(name, true, classes).asSubclass(Measure.class);
            var constructor = type.getConstructor();
            return () -> {
                try {
                    return constructor.newInstance();
                } catch (ReflectiveOperationException failure) {
                    throw new IllegalArgumentException("The measure " + name + " cannot be created.", failure);
                }
            };
        } catch (ReflectiveOperationException | ClassCastException | LinkageError none) {
            throw new IllegalArgumentException(
                    "There is no measure \"" + name + "\". There are: " + names()
                            + ". A class of your own must implement Measure and have a public constructor without parameters.",
                    none);
        }
    }

    /** When the robot has been on its feet for a second. */
    private static Measure getUp() {
        return new Held(1, moment -> moment.robot().isStanding());
    }
}
