package org.robonewbie.protocol.telemetry;

import java.util.Optional;

/**
 * Receiver for the telemetry of robots. Robots call a sink on their own threads during their cycle, so it must be thread-safe, return
 * immediately, and never throw.
 *
 * <pre>{@code
 * TelemetrySink sink = message -> latest.put(message.team() + message.number(), message);
 * try (TelemetryServer server = TelemetryServer.open(TelemetryServer.portFor(agentPort), sink)) { ... }
 * }</pre>
 */
@FunctionalInterface
public interface TelemetrySink {

    /** A sink that ignores everything. */
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
     * Returns whether the sink currently uses telemetry. Robots call this method in each cycle and skip the work if it
     * returns false.
     *
     * @return false if {@link #accept} has no effect
     */
    default boolean isWanted() {
        return true;
    }

    /**
     * Returns the pending requests to tune declared parameters. Robots check them in each cycle.
     *
     * @return the requests; empty if the sink does not support tuning
     */
    default Optional<TuningRequests> tuningRequests() {
        return Optional.empty();
    }
}
