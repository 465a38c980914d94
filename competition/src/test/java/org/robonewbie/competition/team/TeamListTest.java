package org.robonewbie.competition.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TeamListTest {

    @Test
    void teamsKeepTheirOrderAndWhatIsSaidOfThem() {
        List<TeamEntry> teams = TeamList.parse(List.of(
                "# the course of May", "Zebras = teams/zebras", "", "Zebras.members = Ada, Alan", "Ants = a b {port}"));

        assertThat(teams).extracting(TeamEntry::name).containsExactly("Zebras", "Ants");
        assertThat(teams).extracting(TeamEntry::program).containsExactly("teams/zebras", "a b {port}");
        assertThat(teams.get(0).members()).isEqualTo("Ada, Alan");
        assertThat(teams.get(0).title()).isEqualTo("Zebras");
    }

    @Test
    void programAloneNamesTheTeam() {
        List<TeamEntry> teams = TeamList.parse(List.of(
                "teams/red-ants",
                "blue.jar",
                "Agent_SimpleSoccer",
                "Agent_SimpleSoccer",
                "Agent_SimpleSoccer_of_Anna"));

        assertThat(teams)
                .extracting(TeamEntry::name)
                .containsExactly(
                        "red_ants", "blue", "Agent_SimpleSoccer", "Agent_SimpleSocce_2", "Agent_SimpleSoccer_o");
    }

    @Test
    void eleventhTeamIsRefused() {
        List<String> ten =
                IntStream.rangeClosed(1, 10).mapToObj(i -> "T" + i + "=x").toList();
        List<String> eleven =
                IntStream.rangeClosed(1, 11).mapToObj(i -> "T" + i + "=x").toList();

        assertThat(TeamList.parse(ten)).hasSize(10);
        assertThatThrownBy(() -> TeamList.parse(eleven))
                .isInstanceOf(WrongEntryException.class)
                .hasMessage(
                        "A competition has at most 10 teams, and these are 11. Hold two groups, each with a folder of"
                                + " results of its own.");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "a-b=x; \"a-b\" cannot be the name of a team",
                "A=; Team A has no program",
                "A=x,a=y; Two teams are called a",
                "A=x,A.color=red; \"A.color\" is unknown. After the name of a team may stand: attacker, folder,",
                "A=x,A.seed=many; A.seed = many is no whole number",
                "A=x,A.together=perhaps; A.together = perhaps is not clear. Write yes or no.",
                "B.seed=3; Something is said of team B, but no line says what its program is."
            })
    void mistakeIsToldWithWhatToWrite(String lines, String message) {
        assertThatThrownBy(() -> TeamList.parse(List.of(lines.split(",", -1))))
                .isInstanceOf(WrongEntryException.class)
                .hasMessageStartingWith(message);
    }

    @Test
    void missingFileIsToldWithItsName() {
        assertThatThrownBy(() -> TeamList.read(Path.of("nothing.properties")))
                .isInstanceOf(WrongEntryException.class)
                .hasMessageStartingWith("The file of teams nothing.properties cannot be read");
    }
}
