/**
 * One class for each exercise: its scene and how a solution is judged. Read {@link org.robonewbie.exercises.task.RaiseArmsTask}
 * first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.task;
