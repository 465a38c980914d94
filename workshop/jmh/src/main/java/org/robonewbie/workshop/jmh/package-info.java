/**
 * JMH benchmarks of the agent cycle and the world. Start with {@link org.robonewbie.workshop.jmh.AgentCycle}.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.jmh;
