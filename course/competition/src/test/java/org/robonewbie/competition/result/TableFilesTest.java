package org.robonewbie.competition.result;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Table;
import org.robonewbie.competition.contest.TeamResult;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.team.TeamList;
import org.robonewbie.programs.CalledWronglyException;

class TableFilesTest {

    private static final Table TABLE = new Table(
            "Scoring",
            "Who scores first is first.",
            List.of("Goal after"),
            List.of(
                    new Table.Row(1, "Red", List.of("41.20 s"), List.of("scoring-Red")),
                    new Table.Row(2, "Blue", List.of("–"), List.of())));

    @TempDir
    Path folder = Path.of("");

    @Test
    void tableIsWrittenInThreeFormsAndOneCertificateForEachTeam() throws IOException {
        write("Red=x", "Red.title=Ants, \"red\" <b>", "Red.members=Ada & Alan", "Blue=y");

        assertThat(text("table.csv"))
                .isEqualTo(
                        "Rank,Team,Title,Goal after\r\n1,Red,\"Ants, \"\"red\"\" <b>\",41.20 s\r\n2,Blue,Blue,–\r\n");
        assertThat(text("table.json")).contains("\"Goal after\": \"41.20 s\"", "\"recordings/scoring-Red.rec\"");
        assertThat(text("table.html"))
                .contains(
                        "Ants, &quot;red&quot; &lt;b&gt;",
                        "Ada &amp; Alan",
                        "41.20 s",
                        "certificates/Blue.html",
                        "Programs ran without a sandbox (too far).")
                .containsOnlyOnce(">robonewbie studio recordings/scoring-Red.rec</a>")
                .doesNotContain("http", "<b>");
        assertThat(text("certificates/Red.html")).contains("finished 1st of 2", "@page", "41.20 s");
        assertThat(text("certificates/Blue.html")).contains("finished 2nd of 2");
    }

    @Test
    void teamThatDoesNotCompileGetsNoCertificate() throws IOException {
        Table table =
                new Table("Scoring", "Rule.", List.of(), List.of(new Table.Row(1, "Red", List.of(), List.of(), false)));
        try (ResultFolder results = ResultFolder.open(folder)) {
            Files.writeString(folder.resolve("certificates/Red.html"), "of an earlier contest");

            new TableFiles(results, TeamList.parse(List.of("Red=x"))).write(table, 1, List.of());
        }

        assertThat(folder.resolve("certificates/Red.html")).doesNotExist();
        assertThat(text("table.html")).doesNotContain("certificates/");
    }

    @Test
    void recordingsAreBoundToTheTableByTheirChecksums() throws IOException {
        TrialResult result = new TrialResult("scoring-Red", 1, 41.2, List.of());
        try (ResultFolder results = ResultFolder.open(folder)) {
            Files.writeString(results.recording("scoring-Red"), "abc");
            results.save(result, "circumstances");
            Files.writeString(results.recording("scoring-Red"), "forged");
            Files.writeString(folder.resolve("trials/scoring-Red.json"), "forged");

            List<String> told = results.repair();
            new TableFiles(results, TeamList.parse(List.of("Red=x", "Blue=y"))).write(TABLE, 1, List.of());

            String sum = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
            assertThat(text("recordings.sha256")).isEqualTo(sum + "  recordings/scoring-Red.rec\n");
            assertThat(text("table.json")).contains("\"recordings/scoring-Red.rec\": \"" + sum + "\"");
            assertThat(text("trials/scoring-Red.json")).contains(sum).contains("41.2");
            assertThat(told)
                    .containsExactly(
                            "The file " + folder.resolve("trials/scoring-Red.json")
                                    + " was modified during the contest and has been restored.",
                            "The recording " + results.recording("scoring-Red")
                                    + " was modified after its trial; the checksum in the table is the original one.");
        }
    }

    @Test
    void finishedTrialIsReadAgainOnlyUnderTheSameCircumstances() throws IOException {
        TrialResult result = new TrialResult(
                "scoring-Red", 1, 41.2, List.of(TeamResult.of("Red", Ending.PLAYED, Map.of("goalSeconds", 41.2))));
        try (ResultFolder results = ResultFolder.open(folder)) {
            results.save(result, "abc");
        }

        try (ResultFolder results = ResultFolder.open(folder)) {
            assertThat(results.load("scoring-Red", "other")).isFalse();
            assertThat(results.load("scoring-Red", "abc")).isTrue();
            assertThat(results.find("scoring-Red")).contains(result);
        }
    }

    @Test
    void damagedFileIsAsGoodAsNone() throws IOException {
        try (ResultFolder results = ResultFolder.open(folder)) {
            Files.writeString(folder.resolve("trials/scoring-Red.json"), "{\"circumstances\":\"abc\"}");
            Files.writeString(folder.resolve("trials/scoring-Blue.json"), "");

            assertThat(results.load("scoring-Red", "abc")).isFalse();
            assertThat(results.load("scoring-Blue", "abc")).isFalse();
        }
    }

    @Test
    void folderServesOneContestAtATime() throws IOException {
        try (ResultFolder results = ResultFolder.open(folder)) {
            assertThat(results.file("table.csv")).doesNotExist();
            assertThatThrownBy(() -> ResultFolder.open(folder))
                    .isInstanceOf(CalledWronglyException.class)
                    .hasMessage("Another competition is using the folder " + folder
                            + ". Wait until it ends, or choose another folder with --results.");
        }
    }

    private void write(String... teams) throws IOException {
        try (ResultFolder results = ResultFolder.open(folder)) {
            new TableFiles(results, TeamList.parse(List.of(teams)))
                    .write(TABLE, 1, List.of("Programs ran without a sandbox (too far)."));
        }
    }

    private String text(String file) throws IOException {
        return Files.readString(folder.resolve(file));
    }
}
