package org.robonewbie.competition.result;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;

/** Writes and reads finished trials as JSON. */
final class TrialJson {

    static final Gson PRETTY =
            new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

    private TrialJson() {}

    /**
     * Writes a result.
     *
     * @param circumstances checksum of all that the trial depends on
     */
    static String write(TrialResult result, String circumstances) {
        JsonObject json = new JsonObject();
        json.addProperty("trial", result.id());
        json.addProperty("circumstances", circumstances);
        json.addProperty("seed", result.seed());
        json.addProperty("seconds", result.seconds());
        JsonArray teams = new JsonArray();
        for (TeamResult team : result.teams()) {
            JsonObject own = new JsonObject();
            own.addProperty("team", team.team());
            own.addProperty("ending", team.ending().name());
            JsonObject figures = new JsonObject();
            team.figures().forEach(figures::addProperty);
            own.add("figures", figures);
            teams.add(own);
        }
        json.add("teams", teams);
        return PRETTY.toJson(json) + "\n";
    }

    /** Reads a result; empty if it was made under other circumstances or cannot be read, so that the trial is run again. */
    static Optional<TrialResult> read(String text, String circumstances) {
        try {
            JsonObject json = JsonParser.parseString(text).getAsJsonObject();
            if (!json.get("circumstances").getAsString().equals(circumstances)) {
                return Optional.empty();
            }
            List<TeamResult> teams = new ArrayList<>();
            for (JsonElement team : json.getAsJsonArray("teams")) {
                teams.add(team(team.getAsJsonObject()));
            }
            return Optional.of(new TrialResult(
                    json.get("trial").getAsString(),
                    json.get("seed").getAsLong(),
                    json.get("seconds").getAsDouble(),
                    teams));
        } catch (JsonParseException | IllegalStateException | IllegalArgumentException | NullPointerException damaged) {
            return Optional.empty();
        }
    }

    private static TeamResult team(JsonObject json) {
        Map<String, Double> figures = new TreeMap<>();
        json.getAsJsonObject("figures")
                .entrySet()
                .forEach(entry -> figures.put(entry.getKey(), entry.getValue().getAsDouble()));
        return TeamResult.of(
                json.get("team").getAsString(),
                Ending.valueOf(json.get("ending").getAsString()),
                figures);
    }
}
