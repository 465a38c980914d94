package org.robonewbie.competition.result;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.team.TeamEntry;
import org.robonewbie.nao.text.Html;

/**
 * A team's certificate, to be printed on A4 in landscape format; place, date and signature are filled in by hand.
 *
 * @param team the team
 * @param table the contest's table
 * @param row the team's row in the table
 */
record Certificate(TeamEntry team, Table table, Table.Row row) {

    private static final String STYLE = """
        @page { size: A4 landscape; margin: 0; }
        body { font-family: Georgia, 'Times New Roman', serif; text-align: center; margin: 0; color: #222;
          background: #fff; }
        main { box-sizing: border-box; width: 297mm; height: 209mm; margin: 0 auto; padding: 20mm;
          border: 3mm double #2a6; }
        h1 { font-size: 34pt; margin: 4mm 0; letter-spacing: 2mm; }
        .team { font-size: 30pt; font-weight: bold; margin: 6mm 0 2mm; }
        .members { font-size: 16pt; min-height: 8mm; }
        .rank { font-size: 24pt; margin: 8mm 0; }
        p { font-size: 14pt; margin: 3mm 0; }
        .signatures { display: flex; justify-content: space-between; margin-top: 22mm; }
        .signatures div { border-top: 0.3mm solid #222; width: 80mm; padding-top: 2mm; font-size: 11pt; }
        """;

    String page() {
        String figures = IntStream.range(0, table.columns().size())
                .mapToObj(i -> table.columns().get(i) + ": " + row.cells().get(i))
                .collect(Collectors.joining(" · "));
        return Html.page("Certificate for " + team.title(), STYLE, """
            <main>
            <p>RoboNewbie</p>
            <h1>CERTIFICATE</h1>
            <p>In the contest &ldquo;%s&rdquo; the team</p>
            <div class="team">%s</div>
            <div class="members">%s</div>
            <div class="rank">finished %s of %d</div>
            <p>%s</p>
            <div class="signatures"><div>Place and date</div><div>For the organisers</div></div>
            </main>
            """.formatted(
                        Html.text(table.title()),
                        Html.text(team.title()),
                        Html.text(team.members()),
                        ordinal(row.rank()),
                        table.rows().size(),
                        Html.text(figures)));
    }

    private static String ordinal(int rank) {
        return switch (rank) {
            case 1 -> "1st";
            case 2 -> "2nd";
            case 3 -> "3rd";
            default -> rank + "th";
        };
    }
}
