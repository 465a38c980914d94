/**
 * Robots that are controlled manually from the studio. Each runs its cycle in a separate thread.
 *
 * <p><strong>Internal</strong>: not part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.puppet;
