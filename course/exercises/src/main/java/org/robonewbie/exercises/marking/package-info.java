/**
 * Grading of the programs of all students in a course, with a table of grades and a plagiarism check. Start with {@link
 * org.robonewbie.exercises.marking.ClassMarking}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.marking;
