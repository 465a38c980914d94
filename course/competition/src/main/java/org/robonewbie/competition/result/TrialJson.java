package org.robonewbie.competition.result;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonParseException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;

/** JSON format of finished trials. */
final class TrialJson {

    static final Gson PRETTY =
            new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

    private TrialJson() {}

    /** A finished trial with the checksum of everything on which it depends. */
    private record Finished(
            String trial,
            String circumstances,
            long seed,
            double seconds,
            List<TeamResult> teams,
            @Nullable String recordingSha256) {}

    /** A result and the checksum of its recording; the checksum is empty if there is no recording. */
    record Kept(TrialResult result, String recordingSha256) {}

    /**
     * Formats a result as JSON.
     *
     * @param circumstances checksum of everything that the result depends on
     */
    static String write(Kept kept, String circumstances) {
        TrialResult result = kept.result();
        return PRETTY.toJson(new Finished(
                        result.id(),
                        circumstances,
                        result.seed(),
                        result.seconds(),
                        result.teams(),
                        kept.recordingSha256()))
                + "\n";
    }

    /**
     * Parses a result. Returns empty if it is damaged or was saved with a different checksum; the trial is then repeated.
     */
    static Optional<Kept> read(String text, String circumstances) {
        try {
            Finished found = PRETTY.fromJson(text, Finished.class);
            return found.circumstances().equals(circumstances)
                    ? Optional.of(new Kept(
                            new TrialResult(found.trial(), found.seed(), found.seconds(), found.teams()),
                            Objects.requireNonNullElse(found.recordingSha256(), "")))
                    : Optional.empty();
        } catch (JsonParseException | IllegalArgumentException | NullPointerException damaged) {
            return Optional.empty();
        }
    }
}
