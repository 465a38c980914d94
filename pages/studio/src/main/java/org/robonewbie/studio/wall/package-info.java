/**
 * The page on which the trials of a contest are watched, all that run and the table. {@link org.robonewbie.studio.wall.TrialWall}
 * first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.wall;
