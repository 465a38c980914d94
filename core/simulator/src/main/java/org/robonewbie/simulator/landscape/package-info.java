/**
 * Things on the pitch besides the goals and the ball. Read {@link org.robonewbie.simulator.landscape.Landscape} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.landscape;
