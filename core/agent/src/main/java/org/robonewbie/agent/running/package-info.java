/**
 * What a running program needs around its robots: a simulator to connect to, threads, clocks, files and the environment. The rest of
 * the module does without. Read {@link org.robonewbie.agent.running.SimulatorConnection} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.agent.running;
