/**
 * Communication between players, in messages of 20 characters. Read {@link org.robonewbie.team.talk.TeamMessage} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.talk;
