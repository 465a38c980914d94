/**
 * One class for each exercise: its scene and how a solution is judged. Read {@link org.robonewbie.exercises.task.RaiseArmsTask}
 * first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.task;
