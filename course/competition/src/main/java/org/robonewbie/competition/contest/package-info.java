/**
 * Contests: their trials, judges and ranking. Read {@link org.robonewbie.competition.contest.Contest} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.contest;
