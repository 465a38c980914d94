/**
 * Telemetry, sent alongside the soccer protocol: log lines, the motion being played, what robots believe to see, drawings and
 * values to plot. None of it reaches the simulation. Read {@link org.robonewbie.protocol.telemetry.TelemetrySink} first.
 *
 * <p>To receive it, implement {@link org.robonewbie.protocol.telemetry.TelemetrySink}. Robots of the same process get the sink
 * from their embedded simulator ({@code EmbeddedSimulator.telemetry()}, which is that of the simulator's viewer). Robots of
 * other processes reach it through a {@link org.robonewbie.protocol.tcp.TelemetryServer}, which listens on this computer 200
 * above the agent port of the simulator and works alongside any server, including a real rcssserver3d.
 *
 * <p><strong>Internal</strong>: no part of the API, may change with every version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.telemetry;
