/**
 * What a player knows: where it is, where the ball rolls, where the others are. Read {@link org.robonewbie.team.world.WorldModel} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.team.world;
