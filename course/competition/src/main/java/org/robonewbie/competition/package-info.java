/**
 * The competition at the end of a course: many programs, one table, the same each time. Start reading with {@link
 * org.robonewbie.competition.Competition}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition;
