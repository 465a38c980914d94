/**
 * Grading of programs in child processes. Start with {@link org.robonewbie.exercises.grading.ProcessGrader}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.grading;
