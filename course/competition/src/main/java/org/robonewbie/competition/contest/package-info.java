/**
 * Which contests there are: what is tried, who watches, how it is ranked. Start reading with {@link org.robonewbie.competition.contest.Contest}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.contest;
