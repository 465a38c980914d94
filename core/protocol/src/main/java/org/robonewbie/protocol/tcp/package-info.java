/**
 * Connections over TCP: length-prefixed frames, links for agents and monitors, and telemetry between processes.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.tcp;
