package org.robonewbie.studio.course;

import java.util.List;

/**
 * The help that a student has opened for an exercise.
 *
 * @param hints the open hints, in their order
 * @param allHints how many hints there are
 * @param solution whether there is a solution that a teacher has not locked
 * @param triesLeft how many judged tries are missing until it is shown, 0 if none
 */
public record Help(List<String> hints, int allHints, boolean solution, int triesLeft) {

    /** Takes a copy. */
    public Help {
        hints = List.copyOf(hints);
    }
}
