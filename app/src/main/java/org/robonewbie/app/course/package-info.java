/**
 * Exercises graded in processes of their own, exercises as contests, and what a course thought of it. Read {@link org.robonewbie.app.course.GradingProcess} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.course;
