package org.robonewbie.pagejvm;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** The fields of a student's robot, and what they depend on. */
public final class StudentFields {

    private final List<StudentObject> seen = new ArrayList<>();

    private StudentFields() {}

    /**
     * Makes another object of the same class by its constructor without parameters.
     *
     * @param robot the object
     * @return another one; empty if its class is not the student's
     * @throws RuntimeException if there is no such constructor, or if it fails
     */
    public static Optional<?> madeOnceMore(Object robot) {
        return robot instanceof StudentObject own
                ? Optional.of(own.machine().create(own.type().file().name()))
                : Optional.empty();
    }

    /**
     * Gives a robot the values in which two others of its class differ, also in objects of the student to which its fields lead.
     *
     * @param old one of the others
     * @param fresh the other, whose values are taken
     * @param robot is changed
     */
    public static void copyDifferences(Object old, Object fresh, Object robot) {
        if (old instanceof StudentObject before
                && fresh instanceof StudentObject now
                && robot instanceof StudentObject own) {
            new StudentFields().copy(before, now, own);
        }
    }

    private void copy(StudentObject old, StudentObject fresh, StudentObject robot) {
        boolean alike = old.type() == fresh.type() && fresh.type() == robot.type();
        if (!alike || seen.stream().anyMatch(one -> one == robot)) {
            return;
        }
        seen.add(robot);
        for (Map.Entry<String, @Nullable Object> field : robot.fields().entrySet()) {
            Object before = old.fields().get(field.getKey());
            Object now = fresh.fields().get(field.getKey());
            if (isValue(now)) {
                if (!Objects.equals(before, now)) {
                    field.setValue(now);
                }
            } else if (before instanceof StudentObject was
                    && now instanceof StudentObject is
                    && field.getValue() instanceof StudentObject present) {
                copy(was, is, present);
            }
        }
    }

    private static boolean isValue(@Nullable Object value) {
        return value instanceof Number || value instanceof String || value instanceof Record;
    }
}
