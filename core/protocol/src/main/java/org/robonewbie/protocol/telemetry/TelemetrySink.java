package org.robonewbie.protocol.telemetry;

import java.util.Optional;

/**
 * Receives the telemetry of robots. A sink is called by the robots' own threads in the middle of their cycle, so it must be
 * thread-safe, return at once, and never throw.
 *
 * <pre>{@code
 * TelemetrySink sink = message -> latest.put(message.team() + message.number(), message);
 * try (TelemetryServer server = TelemetryServer.open(TelemetryServer.portFor(agentPort), sink)) { ... }
 * }</pre>
 */
@FunctionalInterface
public interface TelemetrySink {

    /** The sink that ignores everything. */
    TelemetrySink NONE = new TelemetrySink() {
        @Override
        public void accept(TelemetryMessage message) {}

        @Override
        public boolean isWanted() {
            return false;
        }
    };

    /**
     * Receives one message.
     *
     * @param message an item of a robot's telemetry
     */
    void accept(TelemetryMessage message);

    /**
     * Returns whether telemetry is wanted now; robots ask in each cycle and save the work if it is not.
     *
     * @return whether {@link #accept} does anything
     */
    default boolean isWanted() {
        return true;
    }

    /**
     * Returns what people want of the numbers that robots declare; robots look in each cycle.
     *
     * @return the wishes; empty where nobody can express any
     */
    default Optional<NumberWishes> wishes() {
        return Optional.empty();
    }
}
