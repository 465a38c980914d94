/** Connections over TCP: frames with a length prefix, agent and monitor links, and telemetry between processes. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.tcp;
