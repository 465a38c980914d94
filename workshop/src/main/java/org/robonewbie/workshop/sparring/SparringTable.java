package org.robonewbie.workshop.sparring;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** Markdown tables with the results of a league. */
final class SparringTable {

    private static final String TITLE = """
            | team | against | won, drawn, lost | goals | ball, m | possession | kicks | m per kick | kick-offs kept | set plays kept \
            | falls per player | median, 90 % speed | near the ball | danger, s |
            |---|---|---|---|---|---|---|---|---|---|---|---|---|---|
            """;
    private static final String RATINGS = """

            | team | Elo |
            |---|---|
            """;

    private SparringTable() {}

    /** Returns the tables of figures and of ratings. */
    static String of(List<SparringMatch.Result> results) {
        Map<String, Row> rows = new LinkedHashMap<>();
        for (SparringMatch.Result result : results) {
            SparringMatch match = result.match();
            row(rows, match.first(), match.second(), match.players())
                    .add(result.first(), result.second(), result.goals());
            if (match.second() != SparringTeam.NOBODY && match.second() != match.first()) {
                row(rows, match.second(), match.first(), match.players())
                        .add(result.second(), result.first(), -result.goals());
            }
        }
        String ratings = EloRatings.of(results).entrySet().stream()
                .map(each -> String.format(
                        Locale.ROOT,
                        "| %s | %+.0f ± %.0f |%n",
                        each.getKey().label(),
                        each.getValue().points(),
                        each.getValue().error()))
                .collect(Collectors.joining());
        return TITLE + rows.values().stream().map(Row::toString).collect(Collectors.joining()) + RATINGS + ratings;
    }

    private static Row row(Map<String, Row> rows, SparringTeam team, SparringTeam other, int players) {
        return rows.computeIfAbsent(team + " " + other, unused -> new Row(team.label(), other.label(), players));
    }

    /** Returns one line for one match. */
    static String line(SparringMatch.Result result) {
        return String.format(
                Locale.ROOT,
                "%s %.0f : %.0f",
                result.match().key(),
                result.first().get(Figure.GOALS),
                result.second().get(Figure.GOALS));
    }

    /** A team's figures against one other team. */
    private static final class Row {

        private final String team;
        private final String other;
        private final int players;
        private final TeamFigures sum = new TeamFigures();
        private final TeamFigures others = new TeamFigures();
        private int won;
        private int drawn;
        private int lost;

        Row(String team, String other, int players) {
            this.team = team;
            this.other = other;
            this.players = players;
        }

        void add(TeamFigures figures, TeamFigures against, double lead) {
            sum.add(figures);
            others.add(against);
            won += lead > 0 ? 1 : 0;
            drawn += lead == 0 ? 1 : 0;
            lost += lead < 0 ? 1 : 0;
        }

        @Override
        public String toString() {
            double halves = won + drawn + lost;
            double held = sum.get(Figure.POSSESSION) + others.get(Figure.POSSESSION);
            return String.format(
                    Locale.ROOT,
                    "| %s | %s | %d, %d, %d | %.0f : %.0f | %+.1f | %.0f %% | %.1f | %.1f | %.0f of %.0f | %.0f of %.0f"
                            + " | %.1f | %.2f, %.2f | %.2f | %.1f |%n",
                    team,
                    other,
                    won,
                    drawn,
                    lost,
                    sum.get(Figure.GOALS),
                    others.get(Figure.GOALS),
                    sum.ratio(Figure.TERRITORY, Figure.SECONDS),
                    100 * sum.get(Figure.POSSESSION) / held,
                    sum.get(Figure.KICKS) / halves,
                    sum.ratio(Figure.KICKED_METRES, Figure.KICKS),
                    sum.get(Figure.KICK_OFFS_KEPT),
                    sum.get(Figure.KICK_OFFS),
                    sum.get(Figure.SET_PLAYS_KEPT),
                    sum.get(Figure.SET_PLAYS),
                    sum.get(Figure.FALLS) / halves / players,
                    sum.speed(0.5),
                    sum.speed(0.9),
                    sum.ratio(Figure.NEAR_BALL, Figure.SECONDS),
                    sum.get(Figure.DANGER) / halves);
        }
    }
}
