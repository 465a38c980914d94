/**
 * What players tell each other, in 20 characters. Read {@link org.robonewbie.team.talk.TeamMessage} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.talk;
