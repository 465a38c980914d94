package org.robonewbie.competition.result;

import java.util.List;
import java.util.stream.Collectors;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.nao.text.Html;

/** HTML page with the results table of a contest, for display and printing. */
final class TablePage {

    private static final String STYLE = """
        :root { color-scheme: light dark; }
        body { font: 1.1rem/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
        h1 { font-size: 1.8rem; margin-bottom: 0.2rem; }
        table { border-collapse: collapse; width: 100%; margin-top: 1.5rem; }
        th, td { text-align: left; padding: 0.5rem 0.8rem; border-bottom: 1px solid #8886; }
        td:first-child { font-weight: bold; font-size: 1.3rem; width: 3rem; }
        .first { background: #fc06; }
        .members, .note { color: #777; font-size: 0.9rem; }
        @media print { .note { display: none; } body { margin: 0; } }
        """;

    private final List<TeamEntry> teams;

    TablePage(List<TeamEntry> teams) {
        this.teams = teams;
    }

    String of(Table table, long seed, List<String> notes) {
        String heads = table.columns().stream()
                .map(column -> "<th>" + Html.text(column) + "</th>")
                .collect(Collectors.joining());
        String rows = table.rows().stream().map(this::row).collect(Collectors.joining());
        return Html.page(table.title(), STYLE, """
            <h1>%s</h1>
            <p>%s</p>
            <table>
            <thead><tr><th></th><th>Team</th>%s<th class="note"></th><th class="note"></th></tr></thead>
            <tbody>
            %s</tbody>
            </table>
            <p class="note">Seed %d. To replay a trial, run its command under “replay” in a terminal, in the folder that
            contains this page. The file recordings.sha256 contains the checksums of all recordings.</p>
            <p class="note">%s</p>
            """.formatted(
                        Html.text(table.title()),
                        Html.text(table.rule()),
                        heads,
                        rows,
                        seed,
                        Html.text(String.join(" ", notes))));
    }

    private String row(Table.Row row) {
        TeamEntry team = teams.stream()
                .filter(candidate -> candidate.name().equals(row.team()))
                .findFirst()
                .orElseThrow();
        String cells = row.cells().stream()
                .map(cell -> "<td>" + Html.text(cell) + "</td>")
                .collect(Collectors.joining());
        String members =
                team.members().isEmpty() ? "" : "<div class=\"members\">" + Html.text(team.members()) + "</div>";
        return """
            <tr%s><td>%d</td><td>%s%s</td>%s<td class="note">%s</td><td class="note">%s</td></tr>
            """.formatted(
                        row.rank() == 1 ? " class=\"first\"" : "",
                        row.rank(),
                        Html.text(team.title()),
                        members,
                        cells,
                        replays(row),
                        row.certified() ? "<a href=\"certificates/" + row.team() + ".html\">certificate</a>" : "");
    }

    /** Returns the commands that replay a team's trials. */
    private static String replays(Table.Row row) {
        if (row.trials().isEmpty()) {
            return "";
        }
        return row.trials().stream()
                .map(trial -> "<a href=\"recordings/" + Html.text(trial) + ".rec\">robonewbie studio recordings/"
                        + Html.text(trial) + ".rec</a>")
                .collect(Collectors.joining("<br>", "<details><summary>replay</summary>", "</details>"));
    }
}
