/**
 * The runtime environment of robot programs: connection to a simulator, threads, clocks, files and environment variables. The
 * rest of the module needs none of these. Read {@link org.robonewbie.agent.running.SimulatorConnection} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.running;
