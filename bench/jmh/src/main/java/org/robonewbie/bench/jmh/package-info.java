/** Measures what an agent's own cycle costs. Read {@link org.robonewbie.bench.jmh.AgentCycle} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.bench.jmh;
