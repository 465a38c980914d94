/**
 * Exercises in the studio: pages choose one, start it and see how it is judged. Read {@link
 * org.robonewbie.studio.course.Course} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.course;
