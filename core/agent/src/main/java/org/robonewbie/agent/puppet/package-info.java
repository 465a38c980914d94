/**
 * Robots that people move by hand from the studio. In the studio each turns its cycle in a thread of its own.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.puppet;
