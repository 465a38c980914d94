/**
 * Start scripts of rcssserver3d, which are written in Ruby: {@link org.robonewbie.simulator.script.StartScript}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.script;
