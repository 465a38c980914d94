/**
 * What robots tell about their thoughts, beside the soccer protocol: log lines, the motion being played, what they believe to
 * see, drawings and values to plot. Nothing of it reaches the simulation. Read
 * {@link org.robonewbie.protocol.telemetry.TelemetrySink} first.
 *
 * <p>To receive it, implement {@link org.robonewbie.protocol.telemetry.TelemetrySink}. Robots of the same process get the sink
 * from their embedded simulator ({@code EmbeddedSimulator.telemetry()}, which is that of the simulator's viewer). Robots of other
 * processes reach it through a {@link org.robonewbie.protocol.telemetry.TelemetryServer}, which listens on this computer 200 above
 * the agent port of the simulator and works beside any server, also a real rcssserver3d.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.protocol.telemetry;
