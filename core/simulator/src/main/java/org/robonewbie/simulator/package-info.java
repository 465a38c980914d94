/**
 * The SimSpark-compatible simulator. {@link org.robonewbie.simulator.SimulationControl} controls a running simulation and {@link
 * org.robonewbie.simulator.SimulationObserver} observes it.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.simulator;
