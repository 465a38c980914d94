package org.robonewbie.programs;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.Objects;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;

/**
 * Creates robots that run a student's program, each with its own copy of the static fields.
 *
 * @param types loads the class with a new class loader on each call
 */
public record StudentsAgents(Supplier<Class<?>> types) implements Supplier<Agent> {

    /**
     * Checks that the class is an agent and can be instantiated.
     *
     * @throws CalledWronglyException if it is not an agent or cannot be instantiated; the message says why
     */
    public StudentsAgents {
        constructor(types.get());
    }

    @Override
    public Agent get() {
        try {
            return constructor(types.get()).newInstance();
        } catch (InvocationTargetException thrown) {
            throw new IllegalStateException("its constructor threw " + thrown.getCause(), thrown.getCause());
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException("it cannot be created", impossible);
        }
    }

    private static Constructor<? extends Agent> constructor(Class<?> type) {
        if (!Agent.class.isAssignableFrom(type)) {
            throw new CalledWronglyException("An exercise needs a class that extends Agent; " + type.getSimpleName()
                    + " does not. \"robonewbie grade EXERCISE --start\" writes a template.");
        }
        try {
            Constructor<? extends Agent> constructor =
                    type.asSubclass(Agent.class).getDeclaredConstructor();
            constructor.setAccessible(true);
            return Objects.requireNonNull(constructor);
        } catch (NoSuchMethodException none) {
            throw new CalledWronglyException("No robot can be created from " + type.getSimpleName()
                    + ": it needs a constructor without parameters.");
        }
    }
}
