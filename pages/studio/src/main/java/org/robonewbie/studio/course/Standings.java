package org.robonewbie.studio.course;

import java.util.List;

/**
 * A student's progress in the whole course.
 *
 * @param sum exercises, points and time, as a sentence
 * @param badges titles of the earned badges
 * @param csv the results as a table for the teacher
 */
public record Standings(String sum, List<String> badges, String csv) {

    /** Defensively copies the list. */
    public Standings {
        badges = List.copyOf(badges);
    }
}
