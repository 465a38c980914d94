/**
 * SimSpark's monitor protocol: messages with the scene and the state of the game. Read {@link
 * org.robonewbie.protocol.monitor.MonitoredWorld} first.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.monitor;
