/**
 * Which contests there are: what is tried, who watches, how it is ranked. Start reading with {@link org.robonewbie.competition.contest.Contest}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.contest;
