package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.app.studio.StudioProcess;

/** On a disk that is really full, whoever saves reads which file it was, and what is there stays as it was. */
@Tag("slow")
@Timeout(90)
@EnabledOnOs(OS.LINUX)
class FullDiskTest {

    private static final String FULL = " cannot be written: the disk is full";

    @TempDir
    private Path folder;

    private Path place = Path.of("");
    private SmallDisk disk;

    @BeforeEach
    void mount() throws Exception {
        place = Files.createDirectory(folder.resolve("disk"));
        disk = SmallDisk.at(place, 200);
    }

    @AfterEach
    void unmount() throws Exception {
        if (disk != null) {
            disk.close();
        }
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.walk(place)) {
            return files.map(file -> place.relativize(file).toString()).sorted().toList();
        }
    }

    @Test
    void dataSetNamesItsFileAndGoesOnWhenThereIsRoom() throws Exception {
        String set = place.resolve("set").toString();
        String[] words = ("record Agent_BasicStructure --runs 2 --seconds 8 --out " + set).split(" ", -1);

        Printed full = Printed.by(words);
        List<String> left = files();
        disk.makeRoom();
        Printed again = Printed.by(words);

        assertThat(full.exitCode()).as(full.toString()).isEqualTo(1);
        assertThat(full.err()).contains(set + "/").contains(FULL).doesNotContain("\tat ");
        assertThat(left).noneMatch(file -> file.endsWith(".part"));
        assertThat(again.exitCode()).as(again.toString()).isZero();
        assertThat(files()).contains("set/runs.csv", "set/cycles/run-00002.csv");
    }

    @Test
    void classNamesItsFileAndGoesOnWhenThereIsRoom() throws Exception {
        Path file = folder.resolve("class/anna/RaiseArms.java");
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(
                file, "public class RaiseArms extends org.robonewbie.agent.Agent { protected void think() {} }");
        disk.fill();
        String results = place.resolve("results").toString();
        String[] words = {
            "grade",
            "raise-arms",
            "--seeds",
            "1",
            "--class",
            folder.resolve("class").toString(),
            "--results",
            results
        };

        Printed full = Printed.by(words);
        List<String> left = files();
        disk.makeRoom();
        Printed again = Printed.by(words);

        assertThat(full.exitCode()).as(full.toString()).isNotZero();
        assertThat(full.err()).contains(results + "/").contains(FULL).doesNotContain("\tat ");
        assertThat(left).noneMatch(name -> name.endsWith(".part") || name.endsWith(".csv") || name.endsWith(".html"));
        assertThat(again.exitCode()).as(again.toString()).isZero();
        assertThat(place.resolve("results/grades.csv")).content().contains("anna,0.0");
    }

    @Test
    void studioNamesItsFileAndTheFormerOneStays() throws Exception {
        List<String> places = List.of("files/program/Mine.java", "files/motion/mine", "scenes/mine");
        try (StudioProcess studio = StudioProcess.start(place)) {
            for (String each : places) {
                assertThat(studio.ask("PUT", each, "// first", "Replace: yes")).startsWith("HTTP/1.1 200");
            }
            disk.fill();
            List<String> before = files();
            byte[] scene = Files.readAllBytes(place.resolve("scenes/mine.rec"));
            byte[] state = Files.readAllBytes(place.resolve("scenes/mine.rec.state"));

            for (String each : places) {
                String version = studio.ask("GET", each, "")
                        .lines()
                        .filter(line -> line.startsWith("Version: "))
                        .map(line -> "Known-" + line)
                        .findFirst()
                        .orElse("X: y");
                assertThat(studio.ask("PUT", each, "// second", "Replace: yes", version))
                        .startsWith("HTTP/1.1 500")
                        .containsPattern("The file \\S*(Mine\\.java|mine\\.txt|mine\\.rec)" + FULL);
            }

            assertThat(files()).isEqualTo(before);
            assertThat(place.resolve("Mine.java")).hasContent("// first");
            assertThat(place.resolve("motions/mine.txt")).hasContent("// first");
            assertThat(place.resolve("scenes/mine.rec")).hasBinaryContent(scene);
            assertThat(place.resolve("scenes/mine.rec.state")).hasBinaryContent(state);
            disk.makeRoom();
            assertThat(studio.ask("PUT", "scenes/mine", "", "Replace: yes")).startsWith("HTTP/1.1 200");
        }
    }
}
