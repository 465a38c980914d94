package org.robonewbie.competition.result;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.text.Csv;

/** Writes the table of a contest as HTML, CSV and JSON, and the certificates. */
public final class TableFiles {

    private static final String CHECKSUMS = "recordings.sha256";

    private final ResultFolder folder;
    private final List<TeamEntry> teams;

    /**
     * Creates a writer.
     *
     * @param folder folder to which the files are written
     * @param teams the teams, with titles and members
     */
    public TableFiles(ResultFolder folder, List<TeamEntry> teams) {
        this.folder = folder;
        this.teams = List.copyOf(teams);
    }

    /**
     * Writes all files.
     *
     * @param table the table
     * @param seed the contest's seed
     * @param notes notes on how the contest was run
     * @throws IOException if a file cannot be written
     */
    public void write(Table table, long seed, List<String> notes) throws IOException {
        AtomicFile.write(folder.file("table.csv"), csv(table));
        AtomicFile.write(folder.file("table.json"), json(table, seed, notes));
        AtomicFile.write(folder.file("table.html"), new TablePage(teams).of(table, seed, notes));
        AtomicFile.write(folder.file(CHECKSUMS), checksums(table));
        for (Table.Row row : table.rows()) {
            Path certificate = folder.file("certificates").resolve(row.team() + ".html");
            if (!row.certified()) {
                Files.deleteIfExists(certificate);
                continue;
            }
            AtomicFile.write(certificate, new Certificate(team(row.team()), table, row).page());
        }
    }

    /** Returns the checksums of the recordings in the format of {@code sha256sum --check}. */
    private String checksums(Table table) {
        return table.rows().stream()
                .flatMap(row -> row.trials().stream())
                .distinct()
                .flatMap(trial ->
                        folder.recordingSha256(trial).stream().map(sum -> sum + "  " + recording(trial) + "\n"))
                .collect(Collectors.joining());
    }

    private static String recording(String trial) {
        return "recordings/" + trial + ".rec";
    }

    private String csv(Table table) {
        List<String> lines = new ArrayList<>();
        lines.add(Csv.line(Stream.concat(Stream.of("Rank", "Team", "Title"), table.columns().stream())));
        for (Table.Row row : table.rows()) {
            lines.add(Csv.line(Stream.concat(
                    Stream.of(
                            String.valueOf(row.rank()),
                            row.team(),
                            team(row.team()).title()),
                    row.cells().stream())));
        }
        return Csv.text(lines);
    }

    private String json(Table table, long seed, List<String> notes) {
        JsonObject json = new JsonObject();
        json.addProperty("contest", table.title());
        json.addProperty("rule", table.rule());
        json.addProperty("seed", seed);
        JsonArray noteTexts = new JsonArray();
        notes.forEach(noteTexts::add);
        json.add("notes", noteTexts);
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
            JsonObject sums = new JsonObject();
            row.trials().forEach(trial -> recordings.add(recording(trial)));
            row.trials()
                    .forEach(trial ->
                            folder.recordingSha256(trial).ifPresent(sum -> sums.addProperty(recording(trial), sum)));
            own.add("recordings", recordings);
            own.add("recordingSha256", sums);
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
