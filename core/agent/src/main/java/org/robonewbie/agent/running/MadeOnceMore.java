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
 * Makes robots once more to see what their fields depend on: what differs between two robots that were made with different numbers
 * was computed from these numbers, and nothing else of a robot that plays has to change.
 */
public final class MadeOnceMore {

    private static final String FRAMEWORK = "org.robonewbie.agent.";

    private final Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());

    private MadeOnceMore() {}

    /**
     * Makes another robot of the same class by its constructor without parameters.
     *
     * @param robot the robot
     * @param <R> its class
     * @return another one; empty if there is no such constructor, or if it fails
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
     * Gives a robot the numbers, texts and records in which two others of its class differ, also in objects of the same program to
     * which its fields lead.
     *
     * @param old one of the others
     * @param fresh the other, whose values are taken
     * @param robot is changed
     * @return whether that was possible
     */
    public static boolean copyDifferences(Object old, Object fresh, Object robot) {
        try {
            new MadeOnceMore().copy(old, fresh, robot);
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
