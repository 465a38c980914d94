package org.robonewbie.protocol.telemetry;

/**
 * Takes what robots tell about their thoughts. A sink is called by the robots' own threads in the middle of their cycle, so it
 * must be safe for several threads, must return at once, and never throws.
 *
 * <pre>{@code
 * TelemetrySink sink = message -> latest.put(message.team() + message.number(), message);
 * try (TelemetryServer server = TelemetryServer.open(TelemetryServer.portFor(agentPort), sink)) { ... }
 * }</pre>
 */
@FunctionalInterface
public interface TelemetrySink {

    /** Nobody is interested. */
    TelemetrySink NONE = new TelemetrySink() {
        @Override
        public void accept(TelemetryMessage message) {}

        @Override
        public boolean isWanted() {
            return false;
        }
    };

    /**
     * Takes one message.
     *
     * @param message what a robot tells
     */
    void accept(TelemetryMessage message);

    /**
     * Tells whether anybody is interested now; robots ask this in each cycle and spare themselves the work if not.
     *
     * @return whether {@link #accept} does anything
     */
    default boolean isWanted() {
        return true;
    }
}
