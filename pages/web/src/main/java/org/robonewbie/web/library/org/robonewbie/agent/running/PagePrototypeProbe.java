package org.robonewbie.web.library.org.robonewbie.agent.running;

import java.util.Optional;
import org.robonewbie.pagejvm.StudentFields;

/**
 * Creates additional instances of a student's robot to find out which fields depend on tunable numbers. Example agents
 * do not need it, because they read these numbers in {@code think()}.
 */
public final class PagePrototypeProbe {

    private PagePrototypeProbe() {}

    /**
     * Creates another instance of a robot's class with the no-arg constructor.
     *
     * @param robot the robot
     * @param <R> its class
     * @return the new instance; empty if there is no such constructor or it fails
     */
    @SuppressWarnings("unchecked")
    public static <R> Optional<R> of(R robot) {
        try {
            return (Optional<R>) StudentFields.newInstance(robot);
        } catch (RuntimeException impossible) {
            return Optional.empty();
        }
    }

    /**
     * Updates a robot with the values in which two instances of its class differ.
     *
     * @param old the old instance
     * @param fresh the new instance, whose values are copied
     * @param robot the robot to update
     * @return always true
     */
    public static boolean copyDifferences(Object old, Object fresh, Object robot) {
        StudentFields.copyDifferences(old, fresh, robot);
        return true;
    }
}
