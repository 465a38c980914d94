/**
 * Grading of the programs of a class, with a table and a plagiarism check. Start with {@link
 * org.robonewbie.exercises.marking.ClassMarking}.
 *
 * <p><strong>Internal</strong>: not part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.marking;
