package org.robonewbie.competition.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.programs.CalledWronglyException;

class TeamListTest {

    @TempDir
    Path folder;

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
                .isInstanceOf(CalledWronglyException.class)
                .hasMessage(
                        "A competition can have at most 10 teams, but there are 11. Split them into two competitions, each"
                                + " with its own results folder.");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "a-b=x; \"a-b\" cannot be the name of a team",
                "A=; Team A has no program",
                "A=x,a=y; Two teams are called a",
                "A=x,A.color=red; \"A.color\" is unknown. Did you mean folder? The settings of a team are: attacker, folder,",
                "A=x,A.seed=many; A.seed = many is not an integer",
                "A=x,A.together=perhaps; A.together = perhaps is invalid. Write yes or no.",
                "B.seed=3; There are settings for team B, but no line for its program."
            })
    void mistakeIsToldWithWhatToWrite(String lines, String message) {
        assertThatThrownBy(() -> TeamList.parse(List.of(lines.split(",", -1))))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith(message);
    }

    @ParameterizedTest
    @CsvSource({
        "Röt, Roet",
        "Équipe, Equipe",
        "Straße_1, Strasse_1",
        "Красные, Krasnye",
        "Ελλάς, Ellas",
        "Şampiyon, Sampiyon",
        "Łódź, Lodz",
        "红队, u7ea2u961f",
        "ÄÄÄÄÄÄÄÄÄÄÄÄÄ, AeAeAeAeAeAeAeAeAeAe",
        "Ro\u0308t, Roet"
    })
    void lettersOfAllLanguagesAreLetters(String written, String ascii) {
        List<TeamEntry> teams =
                TeamList.parse(List.of(written + " = teams/red", written + ".members = Zoë – “Zo” 👩‍🚀", "B=x"));

        assertThat(teams).extracting(TeamEntry::name).containsExactly(ascii, "B");
        assertThat(teams.get(0).title()).isEqualTo(written.equals("Ro\u0308t") ? "Röt" : written);
        assertThat(teams.get(0).members()).isEqualTo("Zoë – “Zo” 👩‍🚀");
        assertThat(teams.get(0).program()).isEqualTo("teams/red");
    }

    @Test
    void settingMayNameTheTeamInAscii() {
        assertThat(TeamList.parse(List.of("Röt=x", "Roet.seed=7")).get(0).seed())
                .contains(7L);
    }

    @ParameterizedTest
    @CsvSource({
        "Red Team = teams/red, Red_Team",
        "Red Team=teams/red, Red_Team",
        "Red-Team=teams/red, Red_Team",
        "'\"Röt\" = teams/red', Röt",
        "Red & Blue = teams/red, Red_Blue",
        "--Red = teams/red, Red",
        "env FAST=1 = teams/red, env_FAST",
        "teams/red = Red, teams_red",
        "? = teams/red, Team",
        "con = teams/red, Team_con",
        "a_name_that_is_far_too_long = teams/red, a_name_that_is_far_t"
    })
    void lineWithAnEqualsSignIsNoCommand(String line, String proposal) {
        assertThatThrownBy(() -> TeamList.parse(List.of(line)))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageContaining("cannot be the name of a team")
                .hasMessageContaining("such as " + proposal + ";")
                .hasMessageContaining("Write: " + proposal + " = ");
        assertThat(TeamList.parse(List.of(proposal + " = teams/red"))).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"python3 green.py --port={port}", "./run.sh -x --port={port} A=b", "java -Dx=y Green", "a b c"})
    void optionOfACommandMayHaveAnEqualsSign(String command) {
        assertThat(TeamList.parse(List.of(command)))
                .extracting(TeamEntry::program)
                .containsExactly(command);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "Röt=x,Roet=y; The teams Röt and Roet are both called Roet in messages and files.",
                "Röt=x,RÖT=y; Two teams are called RÖT.",
                "A=x,A.seed=1,A.seed=2; \"A.seed\" is set twice.",
                "A=x,A.titel=T; \"A.titel\" is unknown. Did you mean title?",
                "Red=x,Rde.seed=1; There are settings for team Rde, but no line for its program. Did you mean Red?",
                "Red\u00A0= x; In \"Red\u00A0= x\", character 4 is a no-break space (U+00A0): type an ordinary space.",
                "R\u0435d = x; In \"R\u0435d = x\", character 2 is the Cyrillic letter \u0435 (U+0435): type e.",
                "Red = teams/red\u200B; In \"Red = teams/red\u200B\", character 16 is an invisible character (U+200B): delete it.",
                "“Red” = x; In \"“Red” = x\", character 1 is the quotation mark “ (U+201C): type ' or \", or none."
            })
    void whatIsNotClearIsRefused(String lines, String message) {
        assertThatThrownBy(() -> TeamList.parse(List.of(lines.split(",", -1))))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith(message);
    }

    @ParameterizedTest
    @CsvSource({
        "UTF-8, '', '\n'",
        "UTF-8, '\uFEFF', '\r\n'",
        "UTF-16LE, '\uFEFF', '\r\n'",
        "UTF-16BE, '\uFEFF', '\n'",
        "windows-1252, '', '\r\n'",
        "UTF-8, '', '\r'"
    })
    void fileOfAnyEditorIsRead(String encoding, String mark, String end) throws IOException {
        String text = mark + String.join(end, "Red = teams/red", "# für alle", "Röt = teams/röt", "");
        Path file = Files.write(folder.resolve("teams.properties"), text.getBytes(Charset.forName(encoding)));

        List<TeamEntry> teams = TeamList.read(file);

        assertThat(teams).extracting(TeamEntry::title).containsExactly("Red", "Röt");
        assertThat(teams.get(1).program()).isEqualTo("teams/röt");
    }

    @Test
    void mistakeInAFileIsToldWithItsLine() throws IOException {
        Path file = Files.writeString(folder.resolve("teams.properties"), "Red = x\n\nBlue Team = y\n");

        assertThatThrownBy(() -> TeamList.read(file))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith(file + ", line 3: \"Blue Team\" cannot be the name of a team.");
    }

    @Test
    void fileThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("teams.zip"), new byte[] {'P', 'K', 3, 4, 0, 0, (byte) 0x81});

        assertThatThrownBy(() -> TeamList.read(file))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }

    @Test
    void missingFileIsToldWithItsName() {
        assertThatThrownBy(() -> TeamList.read(Path.of("nothing.properties")))
                .isInstanceOf(CalledWronglyException.class)
                .hasMessageStartingWith("The file nothing.properties does not exist in the folder ");
    }
}
