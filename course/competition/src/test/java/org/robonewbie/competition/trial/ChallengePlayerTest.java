package org.robonewbie.competition.trial;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.competition.contest.ChallengeContest;
import org.robonewbie.competition.contest.Conditions;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Contests;
import org.robonewbie.competition.contest.Ending;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.programs.BringsTwo;
import org.robonewbie.competition.programs.Crashes;
import org.robonewbie.competition.team.TeamProgram;
import org.robonewbie.programs.process.Limits;
import org.robonewbie.programs.process.Sandbox;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordedCycle;
import org.robonewbie.simulator.recording.RecordingReader;

/** How trials of a challenge end for programs that behave well or badly. */
class ChallengePlayerTest {

    private static final double SECONDS = 0.6;
    private static final Limits LIMITS = new Limits(256, 60, 60, 60, 600);

    private ChallengeContest contest = (ChallengeContest) Contests.scoring(Conditions.of(1), SECONDS);

    @TempDir
    Path folder = Path.of("");

    private Path recording = Path.of("");

    @BeforeEach
    void makeFolders() throws IOException {
        recording = folder.resolve("trial.rec");
        Files.createDirectories(folder.resolve("logs"));
    }

    @Test
    void programThatWantsTwoRobotsPlaysWithOne() throws IOException {
        TrialResult result = play(BringsTwo.class, LIMITS, folder.resolve("work"));

        assertThat(result.of("Red").ending()).isEqualTo(Ending.PLAYED);
        assertThat(result.of("Red").figures()).containsOnlyKeys("ballMetres", "closestMetres");
        assertThat(result.seconds()).isEqualTo(SECONDS);
        assertThat(lastCycle().robots())
                .extracting(robot -> robot.team() + " " + robot.number())
                .containsExactly("Red 2");
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            FallsAsleep | 60  | 0.5 | SILENT      | its program did not respond and was removed.
            HasNoRobot  | 0.5 | 60  | NOT_STARTED | no robot joined. The program did not create a robot.
            Leaves      | 60  | 60  | STOPPED     | end of the trial. The program exited during the trial.
            """)
    void lostTrialTellsWhy(String program, double startSeconds, double silentSeconds, Ending ending, String reason)
            throws Exception {
        Limits limits = new Limits(256, 60, silentSeconds, startSeconds, 600);
        Class<?> type = Class.forName(BringsTwo.class.getPackageName() + "." + program);

        TrialResult result = play(type, limits, folder.resolve("work"));

        assertThat(result.of("Red").ending()).isEqualTo(ending);
        assertThat(log()).contains("The trial is lost: ").contains(reason);
    }

    @Test
    void logNamesTheExitCodeOfAProgramThatHasEnded() throws IOException {
        contest = (ChallengeContest) Contests.scoring(Conditions.of(1), 4);

        TrialResult result = play(Crashes.class, LIMITS, folder.resolve("work"));

        assertThat(result.of("Red").ending()).isEqualTo(Ending.STOPPED);
        assertThat(log()).contains("during the trial. Its exit code is 1.");
        assertThat(result.inWords()).isEqualTo("Red: its program exited before the end of the trial (exit code 1)");
        assertThat(contest.table(List.of("Red"), id -> Optional.of(result)).rows())
                .singleElement()
                .matches(row -> row.cells().contains("its program exited before the end of the trial (exit code 1)"))
                .matches(row -> !row.certified());
    }

    @Test
    void programThatCannotBeStartedHasNotKeptTheWorldWaiting() throws IOException {
        Path noFolder = Files.writeString(folder.resolve("file"), "");

        TrialResult result = play(BringsTwo.class, LIMITS, noFolder);

        assertThat(result.of("Red").ending()).isEqualTo(Ending.NOT_STARTED);
        assertThat(log()).contains("no robot joined. The program could not be started: ");
    }

    private TrialResult play(Class<?> program, Limits limits, Path work) throws IOException {
        TeamProgram red = new TeamProgram.OfJava(
                List.of(), Map.of(Role.MAIN, program.getName()), Optional.empty(), Optional.empty(), false, "none");
        ContestTrial trial =
                contest.trials(List.of("Red"), id -> Optional.empty()).get(0);
        TrialFiles files = new TrialFiles(Optional.of(recording), folder.resolve("logs"), work);
        return new ChallengePlayer(
                        contest.challenge(), Map.of("Red", red), limits, Sandbox.none("not wanted"), Spectators.NOBODY)
                .run(trial, files);
    }

    private String log() throws IOException {
        return Files.readString(folder.resolve("logs/scoring-Red.txt"));
    }

    private WorldSnapshot lastCycle() throws IOException {
        try (RecordingReader reader = RecordingFile.read(recording)) {
            WorldSnapshot last = reader.next().orElseThrow().snapshot();
            for (Optional<RecordedCycle> next = reader.next(); next.isPresent(); next = reader.next()) {
                last = next.get().snapshot();
            }
            return last;
        }
    }
}
