package org.robonewbie.web.library.org.robonewbie.agent.running;

import java.util.Optional;
import org.robonewbie.pagejvm.StudentFields;

/** Makes robots of students' programs once more; compiled ones ask for their numbers in {@code think()}. */
public final class PagePrototypeProbe {

    private PagePrototypeProbe() {}

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
            return (Optional<R>) StudentFields.madeOnceMore(robot);
        } catch (RuntimeException impossible) {
            return Optional.empty();
        }
    }

    /**
     * Gives a robot the values in which two others of its class differ.
     *
     * @param old one of the others
     * @param fresh the other, whose values are taken
     * @param robot is changed
     * @return whether that was possible
     */
    public static boolean copyDifferences(Object old, Object fresh, Object robot) {
        StudentFields.copyDifferences(old, fresh, robot);
        return true;
    }
}
