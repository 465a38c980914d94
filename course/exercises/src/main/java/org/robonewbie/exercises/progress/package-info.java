/**
 * How far somebody is with the exercises, kept in one file of the user, and the help that opens step by step. Read {@link
 * org.robonewbie.exercises.progress.ProgressFile} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.progress;
