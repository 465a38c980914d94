/**
 * The course as a service for the pages of the studio and the web edition. It maps requests to JSON responses and uses no HTTP
 * server, threads, sockets or files. Start with {@link org.robonewbie.exercises.service.CourseService}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.exercises.service;
