package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The command that holds a contest: what it refuses, and what it leaves behind. */
class CompetitionCommandTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void eleventhTeamIsRefused() {
        String[] words = Stream.concat(
                        Stream.of("competition", "scoring"),
                        IntStream.rangeClosed(1, 11).mapToObj(i -> "Team" + i + "=Agent_SimpleSoccer"))
                .toArray(String[]::new);

        Printed printed = Printed.by(words);

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains("A competition has at most 10 teams, and these are 11.");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            running Red=Agent_Wave             | There is no contest "running". There are: scoring, penalties
            penalties Red=Agent_Wave           | needs at least 2 teams
            scoring                            | needs at least 1 team.
            matches A=Agent_Wave B=Agent_Wave --players 12 | --players is 1 to 11
            walk --teams nowhere.properties    | nowhere.properties
            """)
    void mistakeIsToldWithWhatToDo(String line, String message) {
        Printed printed = Printed.by(("competition " + line).split(" ", -1));

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains(message);
    }

    @Test
    void contestLeavesTableCertificatesAndRecordings() throws IOException {
        Path results = folder.resolve("results");

        Printed printed = Printed.by(
                "competition",
                "walk",
                "Red=Agent_Wave",
                "Blue=Agent_Wave",
                "--results",
                results.toString(),
                "--seconds",
                "2");

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.out()).contains("Fastest walk: ", "1.  Red", "1.  Blue", "table.html");
        try (Stream<Path> files = Files.walk(results)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .contains("table.html", "table.csv", "table.json", "Red.html", "walk-Red.rec");
        }
    }
}
