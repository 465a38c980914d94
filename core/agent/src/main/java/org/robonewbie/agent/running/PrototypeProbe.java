package org.robonewbie.agent.running;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Creates further instances of a robot to find out which fields depend on tunable numbers: a value that differs between two
 * instances with different numbers was computed from the numbers. Only such values are updated in a running robot.
 */
public final class PrototypeProbe {

    private static final String FRAMEWORK = "org.robonewbie.agent.";

    private final Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());

    private PrototypeProbe() {}

    /**
     * Creates an instance of the same class with the no-arg constructor.
     *
     * @param robot the robot
     * @param <R> its class
     * @return the instance; empty if there is no such constructor or it fails
     */
    @SuppressWarnings("unchecked")
    public static <R> Optional<R> of(R robot) {
        try {
            Constructor<?> constructor = robot.getClass().getDeclaredConstructor();
            constructor.setAccessible(true);
            return Optional.of((R) constructor.newInstance());
        } catch (ReflectiveOperationException | RuntimeException impossible) {
            return Optional.empty();
        }
    }

    /**
     * Copies the numbers, strings and records that differ between two instances to a third one, including those in
     * objects of the program's own classes to which the fields refer.
     *
     * @param old instance created with the old numbers
     * @param fresh instance created with the new numbers
     * @param robot instance to change
     * @return whether all fields were accessible
     */
    public static boolean copyDifferences(Object old, Object fresh, Object robot) {
        try {
            new PrototypeProbe().copy(old, fresh, robot);
            return true;
        } catch (IllegalAccessException | RuntimeException impossible) {
            return false;
        }
    }

    private void copy(Object old, Object fresh, Object robot) throws IllegalAccessException {
        Class<?> home = robot.getClass();
        if (old.getClass() != home || fresh.getClass() != home || !seen.add(robot)) {
            return;
        }
        for (Class<?> type = home; type != null && isOfProgram(type, home); type = type.getSuperclass()) {
            for (Field field : type.getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers())) {
                    field.setAccessible(true);
                    copy(field, old, fresh, robot);
                }
            }
        }
    }

    private void copy(Field field, Object old, Object fresh, Object robot) throws IllegalAccessException {
        Object before = field.get(old);
        Object now = field.get(fresh);
        Object present = field.get(robot);
        if (isValue(now)) {
            if (!now.equals(before)) {
                field.set(robot, now);
            }
        } else if (before != null && now != null && present != null && isOfProgram(now.getClass(), robot.getClass())) {
            copy(before, now, present);
        }
    }

    private static boolean isOfProgram(Class<?> type, Class<?> program) {
        return type.getClassLoader() == program.getClassLoader()
                && !type.isHidden()
                && !type.getName().startsWith(FRAMEWORK);
    }

    private static boolean isValue(@Nullable Object value) {
        return value instanceof Record
                || value instanceof Enum
                || (value instanceof Comparable
                        && value.getClass().getPackageName().equals("java.lang"));
    }
}
