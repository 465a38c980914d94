/** Exercises graded in processes of their own, exercises as contests, and what a course thought of it. Read {@link org.robonewbie.app.course.GradingProcess} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.app.course;
