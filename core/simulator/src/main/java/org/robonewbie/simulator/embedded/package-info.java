/**
 * How an agent gets a simulator inside its own process. Read {@link
 * org.robonewbie.simulator.embedded.BeginnersSimulatorProvider} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.embedded;
