/**
 * The beat of the world: one cycle of 20 ms after the other, with agents that are told what their robots sense and say what they do.
 * It needs no thread, clock, socket or file. Read {@link org.robonewbie.simulator.cycle.SimulationCycle} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.cycle;
