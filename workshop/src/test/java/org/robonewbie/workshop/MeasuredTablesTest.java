package org.robonewbie.workshop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.workshop.load.ExampleLoad;
import org.robonewbie.workshop.motion.CheckResult;
import org.robonewbie.workshop.motion.MotionCheck;
import org.robonewbie.workshop.motion.MotionMeasurement;
import org.robonewbie.workshop.team.AgentMeasurement;
import org.robonewbie.workshop.team.PlayerChecks;

/**
 * Tables of the documentation with measured figures: they name the command that prints them, and have its rows. The figures
 * are not measured again, since that takes minutes.
 */
class MeasuredTablesTest {

    private static final Pattern FIGURE = Pattern.compile("\\b\\d+\\.\\d{3} (?:m/s|ms|m|s|°/s)(?![\\w/])");

    @Test
    void motionsAreCheckedAsTheTableSays() throws IOException {
        List<MotionCheck> checks = Stream.concat(
                        MotionMeasurement.checks().stream(), PlayerChecks.all(RobotType.TYPE_0).stream())
                .toList();

        assertThat(rows("bench motions --table"))
                .isNotEmpty()
                .allMatch(row -> checks.stream().anyMatch(check -> isOf(check, row)));
    }

    @Test
    void eachExampleHasItsThinkTime() throws IOException {
        assertThat(rows("bench examples"))
                .map(row -> row.split("`", 3)[1])
                .containsExactlyElementsOf(ExampleLoad.examples().keySet());
    }

    @Test
    void agentsPlayWhatTheTableSays() throws IOException {
        Iterator<String> rows = rows("bench agents").iterator();

        AgentMeasurement.rules()
                .forEach((name, rule) -> assertThat(rows.next())
                        .startsWith("| `" + name + "` | ")
                        .endsWith(" | " + rule + " |"));
        assertThat(rows).isExhausted();
    }

    @Test
    void figureOfATableStandsNowhereElse() throws IOException {
        List<PageTable> tables = PageTable.all("");
        String rest = PageTable.textOutsideTables();

        assertThat(tables)
                .isNotEmpty()
                .allSatisfy(table -> assertThat(FIGURE.matcher(table.text()).results())
                        .map(MatchResult::group)
                        .as(table.label())
                        .noneMatch(figure -> rest.contains(" " + figure)));
    }

    private static boolean isOf(MotionCheck check, String row) {
        return row.startsWith(CheckResult.startOfRow(check)) && row.endsWith(check.unit() + " |");
    }

    private static List<String> rows(String command) throws IOException {
        return PageTable.all("measured: " + command).stream()
                .flatMap(table -> table.rows().stream())
                .toList();
    }
}
