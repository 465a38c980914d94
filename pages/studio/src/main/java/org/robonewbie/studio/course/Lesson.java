package org.robonewbie.studio.course;

/**
 * An exercise as a page shows it.
 *
 * @param number its position in the course, from 1
 * @param name such as {@code kick}
 * @param title such as {@code A kick of your own}
 * @param goal what the robot has to do, as a sentence
 * @param level how hard it is, in a word or two
 * @param minutes how long it takes
 * @param points the maximum number of points
 * @param worksheet page of the documentation that explains it
 * @param file usual name of the program that solves it
 * @param standing how far the student is with it
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
     * How far a student is with an exercise.
     *
     * @param tries how often a program was judged
     * @param best the best grade, 0 to 10
     * @param passed whether it was passed once
     * @param minutes time of work until then
     */
    public record Standing(int tries, double best, boolean passed, long minutes) {

        /** Nothing was tried yet. */
        public static final Standing NONE = new Standing(0, 0, false, 0);
    }
}
