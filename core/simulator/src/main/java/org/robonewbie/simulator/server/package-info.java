/**
 * The simulator as a server: its thread, its real-time clock, and its ports for agents and monitors. Read {@link
 * org.robonewbie.simulator.server.Simulator} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.server;
