/**
 * SimSpark's monitor protocol: the scene and the state of the game as a monitor sees them, and the commands of a trainer. Read
 * {@link org.robonewbie.protocol.monitor.MonitoredWorld} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.monitor;
