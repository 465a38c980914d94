package org.robonewbie.studio;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/**
 * Warnings and errors from all robots' programs, without duplicates. Sent to every page, regardless of which robot is
 * selected there.
 */
final class DiagnosticsFeed {

    private static final int MAX_DIAGNOSTICS = 500;
    private static final Set<String> SERIOUS = Set.of("WARNING", "ERROR");

    private final Set<String> sent = new HashSet<>();

    /** Returns a warning or error as JSON; empty for other messages, for duplicates, and once the limit is reached. */
    Optional<String> of(TelemetryMessage message) {
        if (message.item() instanceof TelemetryItem.LogEntry line && SERIOUS.contains(line.level())) {
            String json = SceneDescriptionWriter.diagnostic(message.team(), message.number(), line);
            return sent.size() < MAX_DIAGNOSTICS && sent.add(json) ? Optional.of(json) : Optional.empty();
        }
        return Optional.empty();
    }

    /** Discards the messages of programs that have been replaced, so that recurring messages are reported again. */
    void clear() {
        sent.clear();
    }
}
