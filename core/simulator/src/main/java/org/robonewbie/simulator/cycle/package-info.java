/**
 * The simulation loop of 20 ms cycles and the message exchange with agents, without threads, a clock, sockets or files.
 * Read {@link org.robonewbie.simulator.cycle.SimulationCycle} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.cycle;
