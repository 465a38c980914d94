package org.robonewbie.pagejvm;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** Copies changed values between the fields of students' robots. */
public final class StudentFields {

    private final List<StudentObject> seen = new ArrayList<>();

    private StudentFields() {}

    /**
     * Creates another instance of a robot's class with the no-arg constructor.
     *
     * @param robot the robot
     * @return the new instance; empty if its class is not the student's
     * @throws RuntimeException if there is no such constructor or it fails
     */
    public static Optional<?> newInstance(Object robot) {
        return robot instanceof StudentObject own
                ? Optional.of(own.machine().create(own.type().file().name()))
                : Optional.empty();
    }

    /**
     * Copies to a robot the values that differ between two instances of its class, including objects reachable through its fields.
     *
     * @param old the old instance
     * @param fresh the new instance, whose values are copied
     * @param robot the robot to update
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
