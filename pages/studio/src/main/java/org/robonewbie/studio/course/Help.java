package org.robonewbie.studio.course;

import java.util.List;

/**
 * The help for an exercise that a student has opened.
 *
 * @param hints the opened hints, in order
 * @param allHints total number of hints
 * @param solution whether there is a solution that the teacher has not locked
 * @param triesLeft number of judged tries that are still required before the solution is shown
 */
public record Help(List<String> hints, int allHints, boolean solution, int triesLeft) {

    /** Defensively copies the list. */
    public Help {
        hints = List.copyOf(hints);
    }
}
