/**
 * The SimSpark-compatible simulator. From outside: {@link org.robonewbie.simulator.SimulationControl} steers a running
 * simulation and {@link org.robonewbie.simulator.SimulationObserver} watches it.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator;
