/**
 * How an agent gets a simulator inside its own process. Read {@link
 * org.robonewbie.simulator.embedded.BeginnersSimulatorProvider} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator.embedded;
