/**
 * World model of a player: its pose, the ball and the other robots. Read {@link org.robonewbie.team.world.WorldModel} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.world;
