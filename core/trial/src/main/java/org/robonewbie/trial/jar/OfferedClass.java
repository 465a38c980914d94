package org.robonewbie.trial.jar;

import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;

/** Finds service providers that a jar or folder lists in its {@code META-INF/services}. */
public final class OfferedClass {

    private OfferedClass() {}

    /**
     * Looks up a provider by its simple name.
     *
     * @param type the service type
     * @param simpleName class name without package
     * @param classes the class loader
     * @param <T> type of the service
     * @return the class; empty if there is no provider with this name
     * @throws IllegalArgumentException if a provider cannot be loaded; the message contains its name
     */
    public static <T> Optional<Class<? extends T>> find(Class<T> type, String simpleName, ClassLoader classes) {
        try {
            return ServiceLoader.load(type, classes).stream()
                    .<Class<? extends T>>map(ServiceLoader.Provider::type)
                    .filter(provider -> provider.getSimpleName().equals(simpleName))
                    .findFirst();
        } catch (ServiceConfigurationError e) {
            throw new IllegalArgumentException(
                    "A jar or folder provides a " + type.getSimpleName() + " that cannot be loaded: " + e.getMessage(),
                    e);
        }
    }
}
