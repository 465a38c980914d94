package org.robonewbie.competition;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.competition.contest.Table;

/** Whole contests with real programs. */
@Tag("slow")
class CompetitionTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void contestThatWasKilledGoesOnWhereItWasAndGivesTheSameTable() throws Exception {
        Path broken = folder.resolve("broken");
        Process first = contest(broken);
        readUntilThreeAreFinished(first, broken);
        List<ProcessHandle> programs = first.descendants().toList();
        first.destroyForcibly().waitFor();
        Map<String, FileTime> before = finished(broken);

        ByteArrayOutputStream progress = new ByteArrayOutputStream();
        Table resumed = TenTeams.hold(broken, new PrintStream(progress, true, StandardCharsets.UTF_8));
        Path whole = folder.resolve("whole");
        TenTeams.hold(whole, System.out);

        for (ProcessHandle program : programs) {
            program.onExit().get(5, TimeUnit.MINUTES);
        }
        assertThat(before).hasSizeBetween(3, 9);
        assertThat(finished(broken)).hasSize(10).containsAllEntriesOf(before);
        assertThat(progress.toString(StandardCharsets.UTF_8))
                .startsWith(before.size() + " of 10 trials are already finished; their results are kept.");
        for (String file : List.of("table.html", "table.csv", "table.json", "certificates/Better1.html")) {
            assertThat(broken.resolve(file)).hasSameBinaryContentAs(whole.resolve(file));
        }
        checkBadPrograms(resumed);
        assertThat(whole.resolve("recordings/scoring-Better1.rec")).isNotEmptyFile();
        assertThat(whole.resolve("work")).isDirectoryNotContaining("glob:**scoring*");
    }

    /** The five bad ones stand last and share their place; all others have played. */
    private static void checkBadPrograms(Table table) {
        assertThat(table.rows()).hasSize(10);
        assertThat(table.rows().subList(0, 5))
                .extracting(row -> row.cells().get(3))
                .containsOnly("played to the end");
        assertThat(table.rows().subList(5, 10))
                .extracting(row ->
                        row.rank() + " " + row.team() + ": " + row.cells().get(3))
                .containsExactly(
                        "6 Crasher: its program exited before the end of the trial (exit code 1)",
                        "6 Killed: its program exited before the end of the trial (exit code 137)",
                        "6 Hanger: its program did not respond and was removed",
                        "6 Eater: its program exceeded the memory limit",
                        "6 Leaver: its program exited before the end of the trial (exit code 0)");
    }

    private static Process contest(Path results) throws IOException {
        return new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-XX:+UseSerialGC",
                        "-cp",
                        System.getProperty("java.class.path"),
                        TenTeams.class.getName(),
                        results.toString())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private static Map<String, FileTime> finished(Path results) {
        Map<String, FileTime> times = new TreeMap<>();
        if (!Files.isDirectory(results.resolve("trials"))) {
            return times;
        }
        try (Stream<Path> files = Files.list(results.resolve("trials"))) {
            for (Path file :
                    files.filter(name -> name.toString().endsWith(".json")).toList()) {
                times.put(file.getFileName().toString(), Files.getLastModifiedTime(file));
            }
        } catch (IOException changing) {
            return times;
        }
        return times;
    }

    /** A contest prints a line after each trial. */
    private static void readUntilThreeAreFinished(Process contest, Path results) throws IOException {
        BufferedReader lines = contest.inputReader();
        while (finished(results).size() < 3) {
            assertThat(lines.readLine()).as("the contest ended too early").isNotNull();
        }
    }
}
