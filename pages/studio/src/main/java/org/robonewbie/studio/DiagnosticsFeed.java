package org.robonewbie.studio;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.protocol.telemetry.TelemetryItem;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** What goes wrong in programs, for all pages, whichever robot they watch; the same only once. */
final class DiagnosticsFeed {

    private static final int MOST_MISTAKES = 500;
    private static final Set<String> SERIOUS = Set.of("WARNING", "ERROR");

    private final Set<String> told = new HashSet<>();

    /** Returns a mistake as JSON; empty if the message is none, or an old one. */
    Optional<String> of(TelemetryMessage message) {
        if (message.item() instanceof TelemetryItem.LogEntry line && SERIOUS.contains(line.level())) {
            String json = SceneDescriptionWriter.mistake(message.team(), message.number(), line);
            return told.size() < MOST_MISTAKES && told.add(json) ? Optional.of(json) : Optional.empty();
        }
        return Optional.empty();
    }
}
