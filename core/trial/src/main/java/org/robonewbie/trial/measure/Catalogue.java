package org.robonewbie.trial.measure;

import java.lang.reflect.Constructor;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.trial.jar.OfferedClass;

/**
 * Things that people choose by name: those of the framework, and classes of their own. A jar whose {@code META-INF/services} lists its classes
 * offers them by their simple names, see {@link java.util.ServiceLoader}.
 *
 * <pre>{@code
 * Catalogue<Measure> measures = new Catalogue<>("measure", Measure.class, Map.of("energy", Energy::new));
 * Measure own = measures.named("MyMeasure", classes).get();
 * }</pre>
 *
 * @param <T> their type
 */
public final class Catalogue<T> {

    private final String kind;
    private final Class<T> type;
    private final Map<String, Supplier<T>> all;

    /**
     * Lists the framework's things.
     *
     * @param kind what they are called in messages, such as {@code measure}
     * @param type their type
     * @param all creates each of them, by name
     */
    public Catalogue(String kind, Class<T> type, Map<String, Supplier<T>> all) {
        this.kind = kind;
        this.type = type;
        this.all = new TreeMap<>(all);
    }

    /**
     * Looks up a thing.
     *
     * @param name its name, the simple name of a class that a jar offers, or the full name of a class of this type with a public
     *     constructor without parameters
     * @param classes where to look for the class
     * @return creates a new one each time
     * @throws IllegalArgumentException if there is none of this name; the message names the nearest and lists all
     */
    public Supplier<T> named(String name, ClassLoader classes) {
        Supplier<T> known = all.get(name);
        return known == null ? ofClass(name, classes) : known;
    }

    /** {@return the names of the framework's things, separated by commas} */
    public String names() {
        return String.join(", ", all.keySet());
    }

    private Supplier<T> ofClass(String name, ClassLoader classes) {
        try {
            Optional<Class<? extends T>> offered = OfferedClass.find(type, name, classes);
            Class<?> found = offered.isPresent() ? offered.get() : Class.forName(name, true, classes);
            Constructor<? extends T> constructor = found.asSubclass(type).getConstructor();
            return () -> created(constructor);
        } catch (ReflectiveOperationException | ClassCastException | LinkageError none) {
            throw new IllegalArgumentException(
                    "There is no " + kind + " \"" + name + "\"."
                            + Spelling.question(name, all.keySet())
                            + " There are: " + names() + ". A class of your own must "
                            + (type.isInterface() ? "implement " : "extend ") + type.getSimpleName()
                            + " and have a public constructor without parameters.",
                    none);
        }
    }

    private T created(Constructor<? extends T> constructor) {
        try {
            return constructor.newInstance();
        } catch (ReflectiveOperationException failure) {
            throw new IllegalArgumentException(
                    "The " + kind + " " + constructor.getDeclaringClass().getName() + " cannot be created: "
                            + failure.getCause(),
                    failure);
        }
    }
}
