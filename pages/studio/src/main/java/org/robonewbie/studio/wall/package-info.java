/**
 * Overview page of a contest with all running trials and the results table. Start with {@link
 * org.robonewbie.studio.wall.TrialWall}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.wall;
