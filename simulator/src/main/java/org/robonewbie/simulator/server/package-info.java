/**
 * The server: connections of agents, the cycle of 20 ms and its clock. Read {@link
 * org.robonewbie.simulator.server.SimulationCycle} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.server;
