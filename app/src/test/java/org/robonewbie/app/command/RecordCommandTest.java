package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.Printed;
import org.robonewbie.app.ProcessResult;
import org.robonewbie.app.Project;
import org.robonewbie.app.Python;
import org.robonewbie.app.page.CodeBlock;
import org.robonewbie.programs.process.JavaCommand;

class RecordCommandTest {

    @TempDir
    private Path folder;

    @Test
    void runsBecomeTables() throws IOException {
        Path out = folder.resolve("set");

        Printed printed = record(out, "--runs", "2", "--threads", "1", "--messages");

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
                .containsExactly(
                        "run,seed,cycles,rows,score_left,score_right,failure", "1,3,100,97,0,0,", "2,4,100,97,0,0,");
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

    /** The agent stands still and does not look, so all that differs is drawn from the seeds. */
    @Test
    void runsStartInDifferentPlacesUnlessToldOtherwise() throws IOException {
        Path spread = folder.resolve("spread");
        Path equal = folder.resolve("equal");
        List<String> drawn = List.of("true_torso_x", "true_torso_y", "true_heading", "true_ball_x", "true_ball_y");

        record(spread, "--runs", "2");
        record(equal, "--runs", "2", "--spread", "0,0");

        assertThat(drawn).allSatisfy(column -> {
            assertThat(lastOfRun(spread, 1, column)).isNotEqualTo(lastOfRun(spread, 2, column));
            assertThat(lastOfRun(equal, 1, column)).isEqualTo(lastOfRun(equal, 2, column));
        });
        assertThat(lastOfRun(spread, 1, "true_ball_x")).isNotZero().isBetween(-0.2, 0.2);
        assertThat(lastOfRun(spread, 1, "true_heading")).isBetween(-10.5, 10.5);
    }

    @Test
    void massAndPushesAreDrawnFromTheSeed() throws IOException {
        Path heavy = folder.resolve("heavy");
        Path range = folder.resolve("range");
        Path pushed = folder.resolve("pushed");

        record(heavy, "--option", "mass=2");
        record(range, "--runs", "2", "--option", "mass=0.8..1.2", "--option", "friction=0.5..2");
        record(pushed, "--option", "push=300");

        assertThat(weight(heavy, 1)).isCloseTo(2 * 4.6 * 9.81, within(4.0));
        assertThat(weight(range, 1)).isBetween(0.75 * 45, 1.25 * 45).isNotCloseTo(weight(range, 2), within(0.1));
        assertThat(lastOfRun(pushed, 1, "true_tilt")).isGreaterThan(20);
        assertThat(JsonParser.parseString(Files.readString(range.resolve("dataset.json")))
                        .getAsJsonObject()
                        .get("spread and options")
                        .getAsString())
                .isEqualTo("0.2 m, 10.0 degrees friction=0.5..2.0 mass=0.8..1.2");
    }

    @Test
    void startsOutsideOfThePitchAreRefused() {
        Path out = folder.resolve("set");

        assertThat(record(out, "--", "--pose", "-14,0,0").err())
                .contains("The starting pose (-14.0, 0.0) is outside of the pitch. Choose x from -6.0 to 6.0 m");
        assertThat(record(out, "--league", "--", "--pose", "3,0,0").err()).contains("Choose x from -15.0 to 0.0 m");
        assertThat(record(out, "--option", "frction=2").err()).contains("Did you mean friction?");
        assertThat(record(out, "--option", "reward=2").err()).contains("no option \"reward\"");
        assertThat(record(out, "--spread", "1").err()).contains("--spread needs two numbers");
        assertThat(record(out, "--spread", "-1,0").err()).contains("Choose at most 10.0 m");
        assertThat(out).doesNotExist();
        assertThat(record(out, "--league", "--", "--pose", "-14,0,0").exitCode())
                .isZero();
        assertThat(lastOfRun(out, 1, "true_torso_x")).isBetween(-14.3, -13.7);
    }

    @Tag("slow")
    @Test
    void sameSeedGivesTheSameTables() throws IOException {
        String[] drawn = {"--runs", "3", "--option", "friction=0.5..2", "--option", "push=60", "--threads"};
        record(folder.resolve("one"), with(drawn, Path.of("1")));
        record(folder.resolve("two"), with(drawn, Path.of("3")));

        assertThat(contents("one")).hasSize(8).isEqualTo(contents("two"));
    }

    @Tag("slow")
    @Test
    void tablesOfSeveralRunsAreJoinedToThoseThatOneFileWouldHave() throws IOException {
        record(folder.resolve("single"), "--runs", "3", "--threads", "1");
        record(folder.resolve("joined"), "--runs", "3", "--runs-per-file", "2", "--threads", "1");

        assertThat(folder.resolve("joined/cycles"))
                .isDirectoryContaining("glob:**run-00001-to-00002.csv")
                .isDirectoryContaining("glob:**run-00003.csv")
                .isDirectoryNotContaining("glob:**run-00001.csv");
        List<String> rows = Files.readAllLines(folder.resolve("single/cycles/run-00001.csv"));
        List<String> more = Files.readAllLines(folder.resolve("single/cycles/run-00002.csv"));
        rows.addAll(more.subList(1, more.size()));
        assertThat(Files.readAllLines(folder.resolve("joined/cycles/run-00001-to-00002.csv")))
                .isEqualTo(rows);
    }

    /** All that a program keeps in static fields begins again in each run, whichever process carries it out. */
    @Tag("slow")
    @Test
    void runThatFailsIsToldInTheTableAndTriedAgainByTheNextCall() throws IOException {
        Path agent = Files.writeString(
                folder.resolve("Quitter.java"), """
                import java.nio.file.*;
                import org.robonewbie.agent.Nao;

                public class Quitter {
                    private static int runs;

                    public static void main(String[] args) throws Exception {
                        boolean quits = !Files.exists(Path.of("%1$s", "calm"));
                        runs++;
                        try (Nao nao = Nao.connect(args)) {
                            while (nao.sense()) {
                                if (quits && nao.getTime() > 0.5 && Files.notExists(Path.of("%1$s", "quit"))) {
                                    Files.createFile(Path.of("%1$s", "quit"));
                                    System.err.println("I have had enough of run " + runs + ".");
                                    System.exit(0);
                                }
                                nao.act();
                            }
                        }
                        if (quits) {
                            throw new IllegalStateException("The end surprises me.");
                        }
                    }
                }
                """.formatted(folder.toString().replace('\\', '/')));
        String[] words = {"record", agent.toString(), "--runs", "3", "--seconds", "2", "--threads", "1", "--out"};

        Printed first = Printed.by(with(words, folder.resolve("set")));
        List<String> rows = Files.readAllLines(folder.resolve("set/runs.csv"));

        assertThat(first.exitCode()).isEqualTo(1);
        assertThat(first.err())
                .contains("2 of 3 runs are complete and kept")
                .contains("run 1, seed 1: The program ended its process. It said: I have had enough of run 1.");
        assertThat(rows.get(1))
                .isEqualTo("1,1,0,0,0,0,The program ended its process. It said: I have had enough of run 1.");
        assertThat(rows.get(2))
                .startsWith("2,2,100,97,0,0,The program failed. It said: ")
                .endsWith("The end surprises me. (Quitter.java:21)");
        assertThat(folder.resolve("set/cycles")).isDirectoryNotContaining("glob:**run-00001*");
        assertThat(Files.readString(folder.resolve("set/dataset.json"))).contains("\"complete\": false");

        Files.createFile(folder.resolve("calm"));
        Printed second = Printed.by(with(words, folder.resolve("set")));
        Printed whole = Printed.by(with(words, folder.resolve("whole")));

        assertThat(second.out()).contains("2 runs are already complete and are kept.", "run 1/3, seed 1: 97 rows");
        assertThat(whole.exitCode()).as(whole.err()).isZero();
        assertThat(folder.resolve("set/cycles/run-00001.csv"))
                .hasSameBinaryContentAs(folder.resolve("whole/cycles/run-00001.csv"));
        assertThat(Files.readAllLines(folder.resolve("set/runs.csv")))
                .containsExactly(rows.get(0), "1,1,100,97,0,0,", rows.get(2), rows.get(3));
        assertThat(Files.readString(folder.resolve("set/dataset.json"))).contains("\"complete\": true");
    }

    /** What a kill leaves behind: no table of runs, half of a line, and the last run without its table of cycles. */
    @Tag("slow")
    @Test
    void recordingThatWasKilledGoesOnWithTheRunsThatAreMissing() throws IOException {
        Path whole = folder.resolve("whole");
        Path broken = folder.resolve("broken");
        record(whole, "--runs", "3", "--threads", "1");
        record(broken, "--runs", "3", "--threads", "1");
        Path description = broken.resolve("dataset.json");
        Files.writeString(
                description, Files.readString(description).replace("\"complete\": true", "\"complete\": false"));
        Files.writeString(broken.resolve("runs.txt"), "1 3 100 97 0 0 complete\n2 4 100 97 0 0 complete\n3 5 10");
        Files.delete(broken.resolve("runs.csv"));
        Files.delete(broken.resolve("cycles/run-00002.csv"));
        Files.writeString(broken.resolve("cycles/run-00001.csv"), "kept");

        Printed printed = record(broken, "--runs", "3", "--threads", "1");

        assertThat(printed.exitCode()).as(printed.err()).isZero();
        assertThat(printed.out())
                .contains("1 runs are already complete and are kept.", "run 2/3", "run 3/3")
                .doesNotContain("run 1/3");
        assertThat(broken.resolve("cycles/run-00001.csv")).hasContent("kept");
        assertThat(broken.resolve("cycles/run-00002.csv"))
                .hasSameBinaryContentAs(whole.resolve("cycles/run-00002.csv"));
        assertThat(broken.resolve("runs.csv")).hasSameBinaryContentAs(whole.resolve("runs.csv"));
        assertThat(broken.resolve("runs.txt")).doesNotExist();
    }

    @Tag("slow")
    @Test
    void recordingThatWasMadeInAnotherWayIsNotMixed() throws IOException {
        Path set = folder.resolve("set");
        record(set);
        Path description = set.resolve("dataset.json");
        Files.writeString(
                description,
                Files.readString(description)
                        .replace("\"complete\": true", "\"complete\": false")
                        .replace("\"first seed\": \"3\"", "\"first seed\": \"9\""));

        Printed otherSeed = record(set);
        Printed otherColumns = record(set, "--messages");

        assertThat(otherSeed.exitCode()).isEqualTo(2);
        assertThat(otherSeed.err())
                .contains(
                        "contains an incomplete data set with other settings: first seed is \"9\" there and \"3\" now");
        assertThat(otherColumns.exitCode()).isEqualTo(2);
    }

    @Tag("slow")
    @Test
    void whatCannotBeRecordedIsToldAsACallThatIsWrong() throws IOException {
        Path taken = folder.resolve("taken");
        assertThat(record(taken).exitCode()).isZero();

        assertThat(record(taken).exitCode()).isEqualTo(2);
        assertThat(record(taken).err()).contains("already contains a complete data set. Name another folder");
        assertThat(record(folder.resolve("x"), "--runs", "0").err()).contains("--runs must be at least 1, not 0.");
        assertThat(record(folder.resolve("x"), "--robots", "23").err()).contains("must be from 1 to 22");
        assertThat(Printed.by("record", "Agent_BasicStructure", "--seconds", "0")
                        .err())
                .contains("must be greater than 0");
        assertThat(record(folder.resolve("x"), "--format", "parquet").err()).contains("Unknown option --format.");
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @Test
    void folderThatCannotBeWrittenIsToldAtOnce() throws IOException {
        Path file = Files.writeString(folder.resolve("notes.txt"), "mine");

        Printed inFile = record(file.resolve("set"));
        Printed onFile = record(file);

        assertThat(inFile.exitCode()).isEqualTo(2);
        assertThat(inFile.err()).contains("Cannot write to the folder").contains("Choose another one with --out");
        assertThat(onFile.exitCode()).isEqualTo(2);
        assertThat(file).hasContent("mine");
    }

    @Test
    void filesOfOthersStay() throws IOException {
        Path out = Files.createDirectories(folder.resolve("set"));
        Path notes = Files.writeString(out.resolve("notes.txt"), "mine");

        assertThat(record(out).exitCode()).isZero();

        assertThat(notes).hasContent("mine");
        assertThat(out.resolve("cycles/run-00001.csv")).isRegularFile();
    }

    @Tag("slow")
    @Test
    @EnabledOnOs(OS.LINUX)
    void fullDiskIsToldAndLeavesNothingHalfDone() throws IOException {
        Path cycles = Files.createDirectories(folder.resolve("set/cycles"));
        Files.createSymbolicLink(cycles.resolve("run-00001.csv.part"), Path.of("/dev/full"));

        Printed printed = record(folder.resolve("set"));

        assertThat(printed.exitCode()).isEqualTo(1);
        assertThat(printed.err())
                .contains("Run 1 cannot be written", "run-00001.csv cannot be written: the disk is full");
        assertThat(cycles).isEmptyDirectory();
        assertThat(Files.readString(folder.resolve("set/dataset.json"))).contains("\"complete\": false");
    }

    @Tag("slow")
    @Test
    void recordingThatIsKilledGoesOnAndGivesTheSameTables() throws Exception {
        String[] words = {
            "record", "Agent_BasicStructure", "--runs", "12", "--seconds", "5", "--runs-per-file", "4", "--out"
        };
        Process process = new ProcessBuilder(JavaCommand.ofCommand(List.of(with(words, folder.resolve("one")))))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        List<ProcessHandle> helpers;
        try (BufferedReader lines = process.inputReader()) {
            assertThat(lines.readLine()).startsWith("run ");
            assertThat(lines.readLine()).startsWith("run ");
            helpers = process.descendants().toList();
            process.destroyForcibly().waitFor();
        }
        for (ProcessHandle helper : helpers) {
            helper.onExit().get(20, TimeUnit.SECONDS);
        }
        assertThat(helpers).isNotEmpty();
        assertThat(folder.resolve("one/runs.csv")).doesNotExist();

        Printed again = Printed.by(with(words, folder.resolve("one")));
        Printed whole = Printed.by(with(words, folder.resolve("two")));

        assertThat(again.exitCode()).as(again.err()).isZero();
        assertThat(again.out()).containsPattern("(?m)^([2-9]|10|11) runs are already complete and are kept.");
        assertThat(whole.exitCode()).as(whole.err()).isZero();
        assertThat(contents("one")).hasSize(8).isEqualTo(contents("two"));
    }

    @Tag("slow")
    @Test
    void exampleOfThePageFindsTheDragOfTheBall() throws Exception {
        Python python = new Python(folder);
        python.skipWithout("pandas, pyarrow, gymnasium");
        String dataset = folder.resolve("dataset").toString();
        Printed recorded =
                Printed.by("record", "Agent_BetterSoccer", "--runs", "4", "--seconds", "20", "--out", dataset);
        assertThat(recorded.exitCode()).as(recorded.err()).isZero();
        CodeBlock sample = CodeBlock.on(Project.ROOT.resolve("docs/datasets.md")).stream()
                .filter(block -> block.language().equals("python"))
                .findFirst()
                .orElseThrow();

        parquet(python, "dataset");
        ProcessResult result = python.run("-c", sample.code());

        assertThat(result.code()).as(result.printed()).isZero();
        assertThat(result.printed())
                .contains("drag: 1.073 m/s² for each m/s", "drag: mean error 0.002 m")
                .containsPattern("constant: mean error 0\\.[01]\\d\\d m");
    }

    @Tag("slow")
    @Test
    void parquetOfJoinedTablesHasTheSameRowsInAGroupForEachRun() throws Exception {
        Python python = new Python(folder);
        python.skipWithout("pandas, pyarrow, gymnasium");
        record(folder.resolve("single"), "--runs", "3");
        record(folder.resolve("joined"), "--runs", "3", "--runs-per-file", "3");

        parquet(python, "single");
        parquet(python, "joined");
        ProcessResult result = python.run(
                "-c",
                "import pandas as pd, pyarrow.parquet as pq;"
                        + " f = pq.ParquetFile('joined/parquet/cycles/run-00001-to-00003.parquet'); t = f.read();"
                        + " print(pd.read_parquet('single/parquet/cycles').equals(pd.read_parquet('joined/parquet/cycles')),"
                        + " pd.read_parquet('single/parquet/events').equals(pd.read_parquet('joined/parquet/events')),"
                        + " [f.metadata.row_group(i).column(0).statistics.max for i in range(f.num_row_groups)],"
                        + " f.metadata.metadata[b'first seed'], 0 < t['ball_distance'].null_count < len(t),"
                        + " t.schema.field('cycle').type, t.schema.field('ball_distance').type, t.schema.field('heard').type)");

        assertThat(result.printed().strip()).isEqualTo("True True [1, 2, 3] b'3' True int64 double string");
    }

    private static void parquet(Python python, String set) throws Exception {
        ProcessResult result = python.run("-m", "robonewbie.parquet", set);
        assertThat(result.code()).as(result.printed()).isZero();
    }

    private static Printed record(Path out, String... more) {
        String[] usual = {"record", "Agent_BasicStructure", "--seconds", "2", "--seed", "3", "--out", out.toString()};
        String[] all = Arrays.copyOf(usual, usual.length + more.length);
        System.arraycopy(more, 0, all, usual.length, more.length);
        return Printed.by(all);
    }

    private static String[] with(String[] words, Path out) {
        String[] all = Arrays.copyOf(words, words.length + 1);
        all[words.length] = out.toString();
        return all;
    }

    /** The bytes of all files of a data set, by their names. */
    private Map<String, ByteBuffer> contents(String set) throws IOException {
        Map<String, ByteBuffer> all = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder.resolve(set))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                all.put(folder.resolve(set).relativize(file).toString(), ByteBuffer.wrap(Files.readAllBytes(file)));
            }
        }
        return all;
    }

    private static double weight(Path set, int run) {
        return lastOfRun(set, run, "left_foot_force_up") + lastOfRun(set, run, "right_foot_force_up");
    }

    private static double lastOfRun(Path set, int run, String column) {
        try {
            List<String> rows = Files.readAllLines(set.resolve("cycles/run-0000" + run + ".csv"));
            return Double.parseDouble(cell(rows, column));
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /** A cell of the last row; texts with commas stand at the end only. */
    private static String cell(List<String> rows, String column) {
        int index = List.of(rows.get(0).split(",")).indexOf(column);
        return rows.get(rows.size() - 1).split(",", -1)[index];
    }
}
