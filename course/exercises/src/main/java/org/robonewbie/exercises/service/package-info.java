/**
 * The course as a service for the pages of studio and web edition: requests in, JSON out, without HTTP server, thread, socket or file.
 * Start with {@link org.robonewbie.exercises.service.CourseService}.
 *
 * <p><strong>Internal</strong>: not part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.service;
