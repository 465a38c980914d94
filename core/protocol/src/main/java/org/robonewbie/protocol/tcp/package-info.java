/**
 * Connections over TCP: frames with a length prefix, agent and monitor links, and telemetry between processes.
 *
 * <p><strong>Internal</strong>: not part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.tcp;
