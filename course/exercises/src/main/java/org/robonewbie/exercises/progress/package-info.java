/**
 * Students' progress in the exercises, and the help that is revealed to them step by step. Start with {@link
 * org.robonewbie.exercises.progress.ProgressService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.progress;
