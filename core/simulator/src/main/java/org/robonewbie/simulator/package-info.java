/**
 * The SimSpark-compatible simulator. From outside: {@link org.robonewbie.simulator.SimulationControl} steers a running
 * simulation and {@link org.robonewbie.simulator.SimulationObserver} watches it.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator;
