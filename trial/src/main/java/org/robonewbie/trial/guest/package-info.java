/**
 * Programs of other processes as performers: they come through a {@link org.robonewbie.trial.guest.GuestDoor}, a TCP port that
 * speaks with them as a simulator does.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.guest;
