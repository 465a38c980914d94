package org.robonewbie.competition.result;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonParseException;
import java.util.List;
import java.util.Optional;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;

/** Writes and reads finished trials as JSON. */
final class TrialJson {

    static final Gson PRETTY =
            new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

    private TrialJson() {}

    /** A finished trial, and a checksum of all that it depends on. */
    private record Finished(String trial, String circumstances, long seed, double seconds, List<TeamResult> teams) {}

    /**
     * Writes a result.
     *
     * @param circumstances checksum of all that the trial depends on
     */
    static String write(TrialResult result, String circumstances) {
        return PRETTY.toJson(new Finished(result.id(), circumstances, result.seed(), result.seconds(), result.teams()))
                + "\n";
    }

    /** Reads a result; empty if it was made under other circumstances or cannot be read, so that the trial is run again. */
    static Optional<TrialResult> read(String text, String circumstances) {
        try {
            Finished found = PRETTY.fromJson(text, Finished.class);
            return found.circumstances().equals(circumstances)
                    ? Optional.of(new TrialResult(found.trial(), found.seed(), found.seconds(), found.teams()))
                    : Optional.empty();
        } catch (JsonParseException | IllegalArgumentException | NullPointerException damaged) {
            return Optional.empty();
        }
    }
}
