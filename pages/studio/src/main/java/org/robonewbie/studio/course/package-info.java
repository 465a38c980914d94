/**
 * Exercises in the studio: pages list them, start attempts and show the results. Start with {@link
 * org.robonewbie.studio.course.CourseService}.
 *
 * <p><strong>Internal</strong>: not part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.course;
