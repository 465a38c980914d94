/**
 * Programs of other processes as controllers: they come through a {@link org.robonewbie.trial.guest.GuestDoor}, a TCP port that
 * speaks with them as a simulator does.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.guest;
