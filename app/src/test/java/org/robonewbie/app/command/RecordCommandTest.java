package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;
import org.robonewbie.app.Project;
import org.robonewbie.app.Python;

class RecordCommandTest {

    @TempDir
    private Path folder;

    @Test
    void runsBecomeTables() throws IOException {
        Path out = folder.resolve("set");

        Printed printed = record(out, "--format", "csv", "--runs", "2", "--messages");

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.out()).contains("run 2/2, seed 4: 97 rows");
        List<String> rows = Files.readAllLines(out.resolve("cycles/run-00002.csv"));
        assertThat(rows).hasSize(98);
        assertThat(cell(rows, "seconds")).isEqualTo("2.0");
        assertThat(cell(rows, "team")).isEqualTo("RoboNewbie");
        assertThat(Double.parseDouble(cell(rows, "true_torso_z"))).isBetween(0.3, 0.4);
        assertThat(Double.parseDouble(cell(rows, "true_left_shoulder_pitch")))
                .isCloseTo(Double.parseDouble(cell(rows, "sensed_left_shoulder_pitch")), within(0.006));
        assertThat(rows.get(97)).contains("(GYR (n torso)").contains("(syn)");
        assertThat(Files.readAllLines(out.resolve("events/run-00001.csv"))).contains("1,1,playmode KickOff_Left");
        assertThat(Files.readAllLines(out.resolve("runs.csv")))
                .containsExactly("run,seed,cycles,rows,score_left,score_right", "1,3,100,97,0,0", "2,4,100,97,0,0");
        JsonObject description = JsonParser.parseString(Files.readString(out.resolve("dataset.json")))
                .getAsJsonObject();
        assertThat(description.get("complete").getAsBoolean()).isTrue();
        assertThat(description
                        .getAsJsonObject("tables")
                        .getAsJsonObject("cycles")
                        .getAsJsonArray("columns")
                        .size())
                .isEqualTo(rows.get(0).split(",").length);
    }

    @Test
    void sameSeedGivesTheSameTables() throws IOException {
        record(folder.resolve("one"));
        record(folder.resolve("two"));

        assertThat(folder.resolve("one/cycles/run-00001.parquet"))
                .hasSameBinaryContentAs(folder.resolve("two/cycles/run-00001.parquet"));
        assertThat(folder.resolve("one/events/run-00001.parquet"))
                .hasSameBinaryContentAs(folder.resolve("two/events/run-00001.parquet"));
    }

    /** What a kill leaves behind: no table of runs, half of a line, and the last run without its table of cycles. */
    @Test
    void recordingThatWasKilledGoesOnWithTheRunsThatAreMissing() throws IOException {
        Path whole = folder.resolve("whole");
        Path broken = folder.resolve("broken");
        record(whole, "--format", "csv", "--runs", "3");
        record(broken, "--format", "csv", "--runs", "3");
        Path description = broken.resolve("dataset.json");
        Files.writeString(
                description, Files.readString(description).replace("\"complete\": true", "\"complete\": false"));
        Files.writeString(broken.resolve("runs.txt"), "1 3 100 97 0 0 complete\n2 4 100 97 0 0 complete\n3 5 10");
        Files.delete(broken.resolve("runs.csv"));
        Files.delete(broken.resolve("cycles/run-00002.csv"));
        Files.writeString(broken.resolve("cycles/run-00001.csv"), "kept");

        Printed printed = record(broken, "--format", "csv", "--runs", "3");

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.out())
                .contains("1 runs are complete already and kept.", "run 2/3", "run 3/3")
                .doesNotContain("run 1/3");
        assertThat(broken.resolve("cycles/run-00001.csv")).hasContent("kept");
        assertThat(broken.resolve("cycles/run-00002.csv"))
                .hasSameBinaryContentAs(whole.resolve("cycles/run-00002.csv"));
        assertThat(broken.resolve("runs.csv")).hasSameBinaryContentAs(whole.resolve("runs.csv"));
        assertThat(broken.resolve("runs.txt")).doesNotExist();
    }

    @Test
    void recordingThatWasMadeInAnotherWayIsNotMixed() throws IOException {
        Path set = folder.resolve("set");
        record(set, "--format", "csv");
        Path description = set.resolve("dataset.json");
        Files.writeString(
                description,
                Files.readString(description)
                        .replace("\"complete\": true", "\"complete\": false")
                        .replace("\"first seed\": \"3\"", "\"first seed\": \"9\""));

        Printed otherSeed = record(set, "--format", "csv");
        Printed otherColumns = record(set, "--format", "csv", "--messages");

        assertThat(otherSeed.exitCode()).isEqualTo(2);
        assertThat(otherSeed.err()).contains("was made in another way: first seed is \"9\" there and \"3\" now");
        assertThat(otherColumns.exitCode()).isEqualTo(2);
    }

    @Test
    void whatCannotBeRecordedIsToldAsACallThatIsWrong() throws IOException {
        Path taken = folder.resolve("taken");
        assertThat(record(taken).exitCode()).isZero();

        assertThat(record(taken).exitCode()).isEqualTo(2);
        assertThat(record(taken).err()).contains("holds a complete data set already. Name another folder");
        assertThat(record(folder.resolve("x"), "--runs", "0").err()).contains("--runs 0: give a number of at least 1.");
        assertThat(record(folder.resolve("x"), "--robots", "23").err()).contains("give a number from 1 to 22");
        assertThat(Printed.by("record", "Agent_BasicStructure", "--seconds", "0")
                        .err())
                .contains("give a number greater than 0");
        assertThat(record(folder.resolve("x"), "--format", "xls").exitCode()).isEqualTo(2);
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @Test
    void folderThatCannotBeWrittenIsToldAtOnce() throws IOException {
        Path file = Files.writeString(folder.resolve("notes.txt"), "mine");

        Printed inFile = record(file.resolve("set"));
        Printed onFile = record(file);

        assertThat(inFile.exitCode()).isEqualTo(2);
        assertThat(inFile.err()).contains("cannot be written").contains("Name another one with --out");
        assertThat(onFile.exitCode()).isEqualTo(2);
        assertThat(file).hasContent("mine");
    }

    @Test
    void filesOfOthersStay() throws IOException {
        Path out = Files.createDirectories(folder.resolve("set"));
        Path notes = Files.writeString(out.resolve("notes.txt"), "mine");

        assertThat(record(out).exitCode()).isZero();

        assertThat(notes).hasContent("mine");
        assertThat(out.resolve("cycles/run-00001.parquet")).isRegularFile();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void fullDiskIsToldAndLeavesNothingHalfDone() throws IOException {
        Path cycles = Files.createDirectories(folder.resolve("set/cycles"));
        Files.createSymbolicLink(cycles.resolve("run-00001.csv.part"), Path.of("/dev/full"));

        Printed printed = record(folder.resolve("set"), "--format", "csv");

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.err()).contains("Run 1 cannot be written").contains("Is there room on the disk?");
        assertThat(cycles).isEmptyDirectory();
        assertThat(Files.readString(folder.resolve("set/dataset.json"))).contains("\"complete\": false");
    }

    @Tag("slow")
    @Test
    void agentThatEndsTheProcessDoesNotTakeTheRecordingWithIt() throws Exception {
        Path out = folder.resolve("set");
        Path agent = Files.writeString(folder.resolve("Quitter.java"), """
                import org.robonewbie.agent.Nao;

                public class Quitter {
                    private static int runs;

                    public static void main(String[] args) {
                        runs++;
                        try (Nao nao = Nao.connect(args)) {
                            while (nao.sense()) {
                                if (runs == 2 && nao.getTime() > 1) {
                                    System.exit(0);
                                }
                                nao.act();
                            }
                        }
                    }
                }
                """);

        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        "org.robonewbie.app.Main",
                        "record",
                        agent.toString(),
                        "--runs",
                        "3",
                        "--seconds",
                        "2",
                        "--format",
                        "csv",
                        "--out",
                        out.toString())
                .redirectErrorStream(true)
                .start();
        String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).as(printed).isEqualTo(1);
        assertThat(printed)
                .contains("The process was ended in run 2: by Control-C, or the agent called System.exit")
                .contains("1 of 3 runs are complete and kept");
        assertThat(out.resolve("cycles")).isDirectoryContaining("glob:**run-00001.csv");
        assertThat(out.resolve("cycles")).isDirectoryNotContaining("glob:**run-00002*");
        assertThat(Files.readAllLines(out.resolve("runs.csv"))).hasSize(2);
        assertThat(Files.readString(out.resolve("dataset.json"))).contains("\"complete\": false");
    }

    @Tag("slow")
    @Test
    void pandasReadsItAsThePageTells() throws Exception {
        Python python = new Python(folder);
        python.skipWithout("pandas, pyarrow");
        assertThat(record(folder.resolve("dataset"), "--runs", "2").exitCode()).isZero();
        Matcher sample = Pattern.compile("(?ms)^```python\\R(.*?)^```")
                .matcher(Project.read(Project.ROOT.resolve("docs/datasets.md")));
        assertThat(sample.find()).isTrue();

        Python.Result result = python.run(Map.of(), "-c", sample.group(1));

        assertThat(result.code()).as(result.printed()).isZero();
        assertThat(result.printed()).contains("194 rows").contains("true_tilt is in degrees");
    }

    @Tag("slow")
    @Test
    void whatIsMissingIsNullAndEachGroupTellsItsRange() throws Exception {
        Python python = new Python(folder);
        python.skipWithout("pyarrow");
        assertThat(record(folder.resolve("dataset"), "--runs", "1").exitCode()).isZero();

        Python.Result result = python.run(
                Map.of(),
                "-c",
                "import pyarrow.parquet as pq; f = pq.ParquetFile('dataset/cycles/run-00001.parquet'); t = f.read();"
                        + " s = f.metadata.row_group(0).column(t.schema.get_field_index('ball_distance')).statistics;"
                        + " c = f.metadata.row_group(0).column(t.schema.get_field_index('cycle')).statistics;"
                        + " d = t['ball_distance']; n = [x for x in d.to_pylist() if x is not None];"
                        + " print(d.null_count == s.null_count and 0 < d.null_count < len(d), all(x == x for x in n),"
                        + " (s.min, s.max) == (min(n), max(n)), c.max - c.min + 1 == len(d))");

        assertThat(result.printed().strip()).isEqualTo("True True True True");
    }

    private static Printed record(Path out, String... more) {
        String[] usual = {"record", "Agent_BasicStructure", "--seconds", "2", "--seed", "3", "--out", out.toString()};
        String[] all = Arrays.copyOf(usual, usual.length + more.length);
        System.arraycopy(more, 0, all, usual.length, more.length);
        return Printed.by(all);
    }

    /** A cell of the last row; texts with commas stand at the end only. */
    private static String cell(List<String> rows, String column) {
        int index = List.of(rows.get(0).split(",")).indexOf(column);
        return rows.get(rows.size() - 1).split(",", -1)[index];
    }
}
