/**
 * Things on the pitch besides goals and ball. Read {@link org.robonewbie.simulator.landscape.Landscape} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.landscape;
