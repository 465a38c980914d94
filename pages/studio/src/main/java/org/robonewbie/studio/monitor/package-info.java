/**
 * Watches a SimSpark server, be it ours or rcssserver3d, through its monitor port, and reads the logs that such servers write.
 * Read {@link org.robonewbie.studio.monitor.MonitoredSimulation} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.monitor;
