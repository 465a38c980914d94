package org.robonewbie.trial.jar;

import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;

/** Finds classes that a jar or folder lists in its {@code META-INF/services}. */
public final class OfferedClass {

    private OfferedClass() {}

    /**
     * Looks up a class by its simple name.
     *
     * @param type what it must be
     * @param simpleName its name without package
     * @param classes where to look
     * @param <T> its type
     * @return the class; empty if nobody offers one of this name
     * @throws IllegalArgumentException if a class that is offered cannot be loaded; the message says which
     */
    public static <T> Optional<Class<? extends T>> find(Class<T> type, String simpleName, ClassLoader classes) {
        try {
            return ServiceLoader.load(type, classes).stream()
                    .<Class<? extends T>>map(ServiceLoader.Provider::type)
                    .filter(offered -> offered.getSimpleName().equals(simpleName))
                    .findFirst();
        } catch (ServiceConfigurationError wrong) {
            throw new IllegalArgumentException(
                    "A jar or folder offers a " + type.getSimpleName() + " that cannot be loaded: "
                            + wrong.getMessage(),
                    wrong);
        }
    }
}
