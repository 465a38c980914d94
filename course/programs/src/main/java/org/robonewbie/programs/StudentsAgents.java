package org.robonewbie.programs;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.util.Objects;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;

/** Creates robots from a student's program, each with its own static fields. */
public final class StudentsAgents implements Supplier<Agent> {

    private final Supplier<Class<?>> types;

    private StudentsAgents(Supplier<Class<?>> types) {
        this.types = types;
    }

    /**
     * Takes a class of a student.
     *
     * @param types loads the class, each time with a class loader of its own
     * @return makes a robot for each trial
     * @throws CalledWronglyException if no robot can be made with it; its message says why
     */
    public static StudentsAgents of(Supplier<Class<?>> types) {
        constructor(types.get());
        return new StudentsAgents(types);
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
            throw new CalledWronglyException("An exercise wants a class that extends Agent; " + type.getSimpleName()
                    + " does not. \"robonewbie grade EXERCISE --start\" writes one to begin with.");
        }
        try {
            Constructor<? extends Agent> constructor =
                    type.asSubclass(Agent.class).getDeclaredConstructor();
            constructor.setAccessible(true);
            return Objects.requireNonNull(constructor);
        } catch (NoSuchMethodException none) {
            throw new CalledWronglyException("No robot can be made with " + type.getSimpleName()
                    + ": it needs a constructor without parameters.");
        }
    }
}
