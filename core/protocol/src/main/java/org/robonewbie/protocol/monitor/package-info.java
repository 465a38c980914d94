/**
 * SimSpark's monitor protocol: the scene and the state of the game as a monitor sees them, and the commands of a trainer. Read
 * {@link org.robonewbie.protocol.monitor.MonitoredWorld} first.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.monitor;
