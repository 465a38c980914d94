package org.robonewbie.trial.measure;

import java.lang.reflect.Constructor;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.robonewbie.nao.text.Spelling;
import org.robonewbie.trial.jar.OfferedClass;

/**
 * A registry of factories. It finds the framework's factories and your own classes by name. A jar that lists its
 * classes in {@code META-INF/services} provides them by their simple names; see {@link java.util.ServiceLoader}.
 *
 * <pre>{@code
 * Catalogue<Measure> measures = new Catalogue<>("measure", Measure.class, Map.of("energy", Energy::new));
 * Measure own = measures.named("MyMeasure", classes).get();
 * }</pre>
 *
 * @param <T> type of the created objects
 */
public final class Catalogue<T> {

    private final String kind;
    private final Class<T> type;
    private final Map<String, Supplier<T>> all;

    /**
     * Creates a registry.
     *
     * @param kind word for the created objects in messages, such as {@code measure}
     * @param type type of the created objects
     * @param all the framework's factories by name
     */
    public Catalogue(String kind, Class<T> type, Map<String, Supplier<T>> all) {
        this.kind = kind;
        this.type = type;
        this.all = new TreeMap<>(all);
    }

    /**
     * Creates a registry for which the framework has no factories.
     *
     * @param kind word for the created objects in messages
     * @param type type of the created objects
     */
    public Catalogue(String kind, Class<T> type) {
        this(kind, type, Map.of());
    }

    /**
     * Looks up a factory.
     *
     * @param name a registered name, the simple name of a class provided by a jar, or the full name of a class with a public
     *     no-arg constructor
     * @param classes the class loader
     * @return the factory
     * @throws IllegalArgumentException if the name is unknown; the message suggests the closest name and lists all names
     */
    public Supplier<T> named(String name, ClassLoader classes) {
        Supplier<T> known = all.get(name);
        return known == null ? ofClass(name, classes) : known;
    }

    /** {@return the registered names, separated by commas} */
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
                            + (all.isEmpty() ? "" : " Available: " + names() + ".")
                            + " A class of your own must " + (type.isInterface() ? "implement " : "extend ")
                            + type.getSimpleName()
                            + ", have a public constructor without parameters, and be on the class path.",
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
