/**
 * The simulator inside an agent's process, with its view in the browser. Read {@link
 * org.robonewbie.simulator.embedded.BeginnersSimulatorProvider} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.embedded;
