/** Measures what an agent's own cycle costs. Read {@link org.robonewbie.benchmark.AgentCycle} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.benchmark;
