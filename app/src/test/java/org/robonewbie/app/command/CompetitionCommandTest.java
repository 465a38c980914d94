package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.app.Printed;

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
        assertThat(printed.err()).contains("A competition can have at most 10 teams, but there are 11.");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            running                            | Unknown contest "running". Choose one of: scoring, penalties
            running Red=Agent_Wave             | Unknown contest "running". Choose one of: scoring, penalties
            penalties Red=Agent_Wave           | needs at least 2 teams
            league Red=Agent_Team              | needs at least 2 teams
            scoring                            | needs at least 1 team.
            matches A=Agent_Wave B=Agent_Wave --players 12 | --players must be 1 to 11
            exercise:kickk Red=Agent_Wave      | There is no exercise "kickk". Did you mean kick?
            walk --teams nowhere.properties    | nowhere.properties
            """)
    void mistakeIsToldWithWhatToDo(String line, String message) {
        Printed printed = Printed.by(("competition " + line).split(" ", -1));

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).contains(message);
    }

    @Test
    void contestWithoutFenceSaysSo() throws IOException {
        Path results = folder.resolve("results");

        Printed printed = Printed.by(
                ("competition walk Red=Agent_Wave --seconds 2 --fence none --results " + results).split(" ", -1));

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(Files.readString(results.resolve("table.html")))
                .contains("Programs ran without a sandbox (--fence none).", "Connections to each team's port were");
        assertThat(results.resolve("recordings.sha256")).content().contains("  recordings/walk-Red.rec");
    }

    @Test
    void contestLeavesTableCertificatesAndRecordings() throws IOException {
        Path results = folder.resolve("results");

        Printed printed = Printed.by(
                "competition",
                "walk",
                "Red=Agent_Dummy",
                "Blue=Agent_Dummy",
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

    @Tag("slow")
    @Test
    void leagueOfWholeTeamsGoesOnWhereItWasAndKeepsItsTable() throws IOException {
        Path results = folder.resolve("league");
        String[] words = ("competition league Blue=Agent_Team Blue.together=yes Red=Agent_Team --players 2 --seconds 1"
                        + " --results " + results)
                .split(" ", -1);

        Printed first = Printed.by(words);
        byte[] table = Files.readAllBytes(results.resolve("table.csv"));
        Files.delete(results.resolve("trials/league-Red-Blue.json"));
        Printed again = Printed.by(words);

        assertThat(first.exitCode()).as(first.err()).isZero();
        assertThat(first.out().replaceAll(" +", " "))
                .contains(
                        "League, 2 against 2: Each team plays every other team twice, home and away, by the league's rules, for 1 s.")
                .contains("1. Blue 2 0 2 0 0:0 0 2")
                .contains("1. Red 2 0 2 0 0:0 0 2");
        assertThat(again.out()).contains("1 of 2 trials are already finished", "[2/2] league-Red-Blue");
        assertThat(results.resolve("table.csv")).hasBinaryContent(table);
        assertThat(results.resolve("recordings/league-Blue-Red.rec")).isNotEmptyFile();
        assertThat(results.resolve("certificates/Blue.html")).exists();
    }

    @Tag("slow")
    @Test
    void exerciseIsAContestJudgedByItsOwnChecker() throws IOException {
        Path results = folder.resolve("results");
        Path teams = Files.createDirectory(folder.resolve("teams"));
        Path good = Files.writeString(teams.resolve("Good.java"), program("Good", """
                nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 4 * (60 - nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH)));
                nao.setJointSpeed(Joint.RIGHT_SHOULDER_PITCH, 4 * (45 - nao.getJointAngle(Joint.RIGHT_SHOULDER_PITCH)));
                """));
        Path leaving = Files.writeString(teams.resolve("Leaving.java"), program("Leaving", "System.exit(0);"));

        Printed printed = Printed.by(
                "competition",
                "exercise:raise-arms",
                "Blue=Agent_BasicStructure",
                "Green=" + leaving,
                "Nought="
                        + Files.writeString(
                                Files.createDirectory(folder.resolve("broken")).resolve("No.java"), "no"),
                "Red=" + good,
                "--rounds",
                "2",
                "--results",
                results.toString());

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.out().replaceAll(" +", " "))
                .contains("Exercise 1: Raise both arms")
                .contains("1. Red 20 of 20 2 of 2 played to the end")
                .contains("2. Blue 0 of 20 0 of 2 played to the end")
                .contains("3. Green 0 of 20 0 of 2 its program exited before the end of the trial");
        assertThat(printed.out().replaceAll(" +", " "))
                .contains("4. Nought 0 of 20 0 of 2 its program does not compile");
        assertThat(results.resolve("certificates/Nought.html")).doesNotExist();
        assertThat(results.resolve("certificates/Blue.html")).exists();
        assertThat(results.resolve("recordings/exercise-raise-arms-Red-2.rec")).isNotEmptyFile();
    }

    private static String program(String name, String thought) {
        return """
                import org.robonewbie.agent.Agent;
                import org.robonewbie.nao.Joint;

                public class %1$s extends Agent {
                    public static void main(String[] args) {
                        new %1$s().run(args);
                    }

                    @Override
                    protected void think() {
                        nao.setJointSpeed(Joint.NECK_YAW, 0);
                        %2$s
                    }
                }
                """.formatted(name, thought);
    }
}
