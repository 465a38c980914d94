package org.robonewbie.studio.course;

/**
 * An exercise as shown on a page.
 *
 * @param number its position in the course, from 1
 * @param name such as {@code kick}
 * @param title such as {@code A kick of your own}
 * @param goal the task of the robot, as a sentence
 * @param level difficulty in a word or two
 * @param minutes estimated time to solve it
 * @param points the maximum number of points
 * @param worksheet documentation page that explains it
 * @param file default file name of the program that solves it
 * @param standing the student's progress
 */
public record Lesson(
        int number,
        String name,
        String title,
        String goal,
        String level,
        int minutes,
        int points,
        String worksheet,
        String file,
        Standing standing) {

    /**
     * A student's progress on one exercise.
     *
     * @param tries number of judged programs
     * @param best best grade, 0 to 10
     * @param passed whether the exercise has been passed
     * @param minutes working time until it was passed
     */
    public record Standing(int tries, double best, boolean passed, long minutes) {

        /** Progress before the first try. */
        public static final Standing NONE = new Standing(0, 0, false, 0);
    }
}
