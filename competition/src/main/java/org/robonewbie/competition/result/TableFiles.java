package org.robonewbie.competition.result;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.nao.file.AtomicFile;

/** Writes the table of a contest as a page, as CSV and as JSON, and a certificate for each team. */
public final class TableFiles {

    private final ResultFolder folder;
    private final List<TeamEntry> teams;

    /**
     * Creates a writer.
     *
     * @param folder where to write
     * @param teams the teams, for their titles and members
     */
    public TableFiles(ResultFolder folder, List<TeamEntry> teams) {
        this.folder = folder;
        this.teams = List.copyOf(teams);
    }

    /**
     * Writes all files.
     *
     * @param table the table
     * @param seed the seed of the contest
     * @throws IOException if a file cannot be written
     */
    public void write(Table table, long seed) throws IOException {
        AtomicFile.write(folder.file("table.csv"), csv(table));
        AtomicFile.write(folder.file("table.json"), json(table, seed));
        AtomicFile.write(folder.file("table.html"), new TablePage(teams).of(table, seed));
        for (Table.Row row : table.rows()) {
            AtomicFile.write(
                    folder.file("certificates").resolve(row.team() + ".html"),
                    new Certificate(team(row.team()), table, row).page());
        }
    }

    /** Writes the table as text with commas, quoted where needed (RFC 4180). */
    private String csv(Table table) {
        List<String> lines = new ArrayList<>();
        lines.add(line(Stream.concat(Stream.of("Rank", "Team", "Title"), table.columns().stream())));
        for (Table.Row row : table.rows()) {
            lines.add(line(Stream.concat(
                    Stream.of(
                            String.valueOf(row.rank()),
                            row.team(),
                            team(row.team()).title()),
                    row.cells().stream())));
        }
        return lines.stream().map(line -> line + "\r\n").collect(Collectors.joining());
    }

    private static String line(Stream<String> cells) {
        return cells.map(cell -> cell.matches("(?s).*[,\"\\r\\n].*") ? "\"" + cell.replace("\"", "\"\"") + "\"" : cell)
                .collect(Collectors.joining(","));
    }

    private String json(Table table, long seed) {
        JsonObject json = new JsonObject();
        json.addProperty("contest", table.title());
        json.addProperty("rule", table.rule());
        json.addProperty("seed", seed);
        JsonArray rows = new JsonArray();
        for (Table.Row row : table.rows()) {
            JsonObject own = new JsonObject();
            own.addProperty("rank", row.rank());
            own.addProperty("team", row.team());
            own.addProperty("title", team(row.team()).title());
            for (int i = 0; i < table.columns().size(); i++) {
                own.addProperty(table.columns().get(i), row.cells().get(i));
            }
            JsonArray recordings = new JsonArray();
            row.trials().forEach(trial -> recordings.add("recordings/" + trial + ".rec"));
            own.add("recordings", recordings);
            rows.add(own);
        }
        json.add("table", rows);
        return TrialJson.PRETTY.toJson(json) + "\n";
    }

    private TeamEntry team(String name) {
        return teams.stream()
                .filter(team -> team.name().equals(name))
                .findFirst()
                .orElseThrow();
    }
}
