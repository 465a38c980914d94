package org.robonewbie.app.marking;

import java.nio.file.Path;
import org.robonewbie.exercises.Exercise;

/**
 * A student's program for one exercise.
 *
 * @param student name of the student or team
 * @param exercise what it is to solve
 * @param file the program, in the folder
 * @param folder a copy of what the student has handed in, with the motions and other classes that it needs
 */
record Submission(String student, Exercise exercise, Path file, Path folder) {}
