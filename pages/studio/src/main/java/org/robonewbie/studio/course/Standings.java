package org.robonewbie.studio.course;

import java.util.List;

/**
 * How far a student is with the whole course.
 *
 * @param sum exercises, points and time, as a sentence
 * @param badges titles of what was reached
 * @param csv the table for a teacher
 */
public record Standings(String sum, List<String> badges, String csv) {

    /** Takes a copy. */
    public Standings {
        badges = List.copyOf(badges);
    }
}
