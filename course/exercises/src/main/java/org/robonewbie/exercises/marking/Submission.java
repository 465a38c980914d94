package org.robonewbie.exercises.marking;

import java.nio.file.Path;
import org.robonewbie.exercises.Exercise;

/**
 * A student's program for one exercise.
 *
 * @param student name of the student or team
 * @param exercise the exercise
 * @param file the program's Java file, inside {@code folder}
 * @param folder copy of all the student's files, including motions and other classes
 */
record Submission(String student, Exercise exercise, Path file, Path folder) {}
