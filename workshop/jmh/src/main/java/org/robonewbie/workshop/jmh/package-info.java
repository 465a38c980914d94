/**
 * Measures what an agent's own cycle costs. Read {@link org.robonewbie.workshop.jmh.AgentCycle} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.jmh;
