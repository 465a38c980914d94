/**
 * Exercises for students and their grading. Read {@link org.robonewbie.exercises.Exercise} first, then {@link
 * org.robonewbie.exercises.Grader}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises;
