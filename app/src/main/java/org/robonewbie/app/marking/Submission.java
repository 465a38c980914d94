package org.robonewbie.app.marking;

import java.nio.file.Path;
import org.robonewbie.exercises.Exercise;

/**
 * A student's program for one exercise.
 *
 * @param student name of the student or team
 * @param exercise what it is to solve
 * @param file the program
 * @param folder where it runs, with the motions and other classes that it needs
 */
record Submission(String student, Exercise exercise, Path file, Path folder) {}
