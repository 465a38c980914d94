/**
 * A simulator that runs by itself: its thread, its pace, its ports for agents and monitors. Read {@link
 * org.robonewbie.simulator.server.Simulator} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.server;
