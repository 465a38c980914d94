package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.programs.process.JavaCommand;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.recording.RecordingReader;

/** Files that users have from the first preview of this version are read, and work that was stopped half-way goes on. */
class FormerFilesTest {

    @TempDir
    private Path folder;

    @BeforeEach
    void copyTheFiles() throws Exception {
        Path files = Path.of(Objects.requireNonNull(FormerFilesTest.class.getResource("/former-files"))
                .toURI());
        try (Stream<Path> all = Files.walk(files)) {
            for (Path file : all.filter(Files::isRegularFile).toList()) {
                Path copy = folder.resolve(files.relativize(file).toString());
                Files.createDirectories(Objects.requireNonNull(copy.getParent()));
                Files.copy(file, copy);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"run.rec, 100", "contest/recordings/stand-Red.rec, 978"})
    void recordingIsRead(String file, int cycles) throws IOException {
        int read = 0;
        try (RecordingReader recording = RecordingFile.read(folder.resolve(file))) {
            while (recording.next().isPresent()) {
                read++;
            }
        }

        assertThat(read).isEqualTo(cycles);
    }

    @Test
    void policyIsRead() {
        assertThat(PolicyFile.read(folder.resolve("stand.policy"))).isNotNull();
    }

    @ParameterizedTest
    @ValueSource(strings = {"bow", "gruss_2013"})
    void motionIsReadAndKeepsItsBytes(String name) throws IOException {
        Path file = folder.resolve("motions").resolve(name + ".txt");
        byte[] bytes = Files.readAllBytes(file);

        MotionFiles.save(MotionFiles.load(file), file);

        assertThat(MotionFiles.load(file).motion().keyframes()).isNotEmpty();
        assertThat(file).hasBinaryContent(bytes);
    }

    @Tag("slow")
    @Test
    void programFindsItsNumbersAndProperties() throws Exception {
        String output = ends(
                0,
                "run",
                "MyAgent.java",
                "--seed",
                "1",
                "--fast",
                "--headless",
                "--seconds",
                "1",
                "--report",
                "now.json");

        assertThat(output).contains("of 45");
        assertThat(folder.resolve("now.json")).content().contains("Lions");
    }

    @Test
    void progressIsShown() throws Exception {
        assertThat(ends(0, "grade", "--progress")).contains("Raise both arms", "begun", "1 try");
    }

    @Tag("slow")
    @Test
    void projectRuns() throws Exception {
        Path project = folder.resolve("my-team");
        String agent = "src/main/java/myteam/MyAgent.java";

        String output = ends(0, project, "run", agent, "--headless", "--fast", "--seed", "1", "--seconds", "3");

        assertThat(output).doesNotContain("There is no motion");
    }

    /** The journal names the class of its experiment, which has changed since then. */
    @Tag("slow")
    @Test
    void experimentGoesOn() throws Exception {
        Path journal = folder.resolve("push.csv.trials");
        String refused = ends(2, "experiment", "push.plan", "--output", "push.csv");
        String header = refused.lines()
                .map(String::strip)
                .filter(line -> line.startsWith("RoboNewbie trials "))
                .reduce((former, present) -> present)
                .orElseThrow();
        AtomicFile.write(journal, Files.readString(journal).replaceFirst("RoboNewbie trials .*", header));

        String resumed = ends(0, "experiment", "push.plan", "--output", "push.csv");

        assertThat(refused).contains("push.csv.trials belongs to another run", "delete the file to start over");
        assertThat(resumed).contains("12 trials are already done");
        assertThat(folder.resolve("push.csv")).content().hasLineCount(41);
    }

    @Tag("slow")
    @Test
    void dataSetGoesOn() throws Exception {
        byte[] first = Files.readAllBytes(folder.resolve("dataset/cycles/run-00001.csv"));
        Path about = folder.resolve("dataset/dataset.json");
        List<String> order = List.of("record MyAgent.java --runs 6 --seconds 1 --spread 0,0 --out dataset");
        String refused = ends(2, order);
        String version = Printed.by("--version").out().strip();
        AtomicFile.write(about, Files.readString(about).replaceFirst("RoboNewbie 2[^\"]*", version));

        ends(0, order);

        assertThat(refused).contains("incomplete data set with other settings: version is \"RoboNewbie 2.0.0");
        assertThat(about).content().contains("\"complete\": true");
        assertThat(folder.resolve("dataset/cycles/run-00001.csv")).hasBinaryContent(first);
    }

    @Tag("slow")
    @Test
    void searchGoesOn() throws Exception {
        String output = ends(
                0,
                List.of("optimise --agent MyAgent.java --objective energy --seconds 0.5 --seeds 1 --population 4"
                        + " --generations 6 --threads 1 --headless --output tuned.numbers --resume"));

        assertThat(output).doesNotContain("generation 1/6").contains("generation 6/6");
        assertThat(folder.resolve("tuned.numbers")).content().contains("goal");
    }

    @Tag("slow")
    @Test
    void trainingIsRefusedAndStays() throws Exception {
        assertThat(ends(2, List.of("learn Stand stand.policy --generations 3 --pairs 2 --hidden 4")))
                .contains("belongs to another run:");

        assertThat(folder.resolve("stand.policy.csv")).content().hasLineCount(3);
    }

    @Tag("slow")
    @Test
    void classIsGraded() throws Exception {
        assertThat(ends(0, "grade", "raise-arms", "--class", "class", "--seeds", "1"))
                .contains("2 students, 2 programs");
    }

    @Tag("slow")
    @Test
    void contestGoesOn() throws Exception {
        String output = ends(
                0, List.of("competition stand --teams teams.properties --results contest --seconds 1 --fence none"));

        assertThat(output).contains("Red", "Blue", "played to the end");
        assertThat(folder.resolve("contest/table.html")).exists();
    }

    private String ends(int exitCode, List<String> line) throws Exception {
        return ends(exitCode, line.get(0).split(" ", -1));
    }

    private String ends(int exitCode, String... arguments) throws Exception {
        return ends(exitCode, folder, arguments);
    }

    /** Runs a command in a folder; returns what it printed. */
    private String ends(int exitCode, Path place, String... arguments) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(JavaCommand.ofCommand(List.of(arguments)));
        builder.environment()
                .put("ROBONEWBIE_PROGRESS", folder.resolve("progress.json").toString());
        Process process =
                builder.directory(place.toFile()).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(output).isEqualTo(exitCode);
        return output;
    }
}
