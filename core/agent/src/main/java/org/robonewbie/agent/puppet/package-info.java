/**
 * Robots that are controlled manually from the studio. Each runs its cycle in a separate thread.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.puppet;
