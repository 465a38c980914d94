/**
 * Watches any SimSpark server, RoboNewbie's or rcssserver3d, through its monitor port, and reads the logs of such servers.
 * Start with {@link org.robonewbie.studio.monitor.MonitoredSimulation}.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.studio.monitor;
