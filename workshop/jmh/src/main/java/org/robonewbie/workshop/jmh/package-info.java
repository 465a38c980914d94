/**
 * JMH benchmarks of the agent cycle and the world. Start with {@link org.robonewbie.workshop.jmh.AgentCycle}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.workshop.jmh;
