package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

    @Test
    void whatCannotBeRecordedIsToldAsACallThatIsWrong() throws IOException {
        Path taken = folder.resolve("taken");
        assertThat(record(taken).exitCode()).isZero();

        assertThat(record(taken).exitCode()).isEqualTo(2);
        assertThat(record(taken).err()).contains("holds a data set already. Name another folder");
        assertThat(record(folder.resolve("x"), "--runs", "0").err()).contains("--runs 0: give a number of at least 1.");
        assertThat(record(folder.resolve("x"), "--robots", "23").err()).contains("give a number from 1 to 22");
        assertThat(Printed.by("record", "Agent_BasicStructure", "--seconds", "0")
                        .err())
                .contains("give a number greater than 0");
        assertThat(record(folder.resolve("x"), "--format", "xls").exitCode()).isEqualTo(2);
        assertThat(folder.resolve("x")).doesNotExist();
    }

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
