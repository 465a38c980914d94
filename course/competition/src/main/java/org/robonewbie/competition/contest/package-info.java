/**
 * Contests, with their trials, judges and rankings. Read {@link org.robonewbie.competition.contest.Contest} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.contest;
