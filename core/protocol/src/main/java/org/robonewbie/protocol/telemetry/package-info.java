/**
 * Telemetry from robots, sent separately from the soccer protocol: log entries, motion progress, estimates of the surroundings,
 * drawings, and values to plot or tune. It never affects the simulation. Read {@link
 * org.robonewbie.protocol.telemetry.TelemetrySink} first.
 *
 * <p>To receive telemetry, implement {@link org.robonewbie.protocol.telemetry.TelemetrySink}. Robots in the same process get
 * the sink from their embedded simulator ({@code EmbeddedSimulator.telemetry()}, the sink of the simulator's viewer). Robots in
 * other processes connect to a {@link org.robonewbie.protocol.tcp.TelemetryServer}, which listens on the simulator's agent port
 * plus 200 and works with any server, including rcssserver3d.
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.telemetry;
