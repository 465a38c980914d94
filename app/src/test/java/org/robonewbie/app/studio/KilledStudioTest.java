package org.robonewbie.app.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.file.StateFile;
import org.robonewbie.simulator.recording.RecordingReader;

/** A studio that is killed while it saves leaves each file in its old or its new version. */
@Tag("slow")
@Timeout(60)
class KilledStudioTest {

    private static final List<String> PLACES = List.of("files/program/Mine.java", "files/motion/mine", "scenes/mine");

    private static final int LINES = 20_000;

    @TempDir
    private Path folder;

    /** A text of many equal lines, so that a partial file is recognised. */
    private static String text(int save) {
        return "// save %5d\n".formatted(save).repeat(LINES);
    }

    private static String version(String answer) {
        return answer.lines()
                .filter(line -> line.startsWith("Version: "))
                .map(line -> line.substring("Version: ".length()))
                .findFirst()
                .orElse("");
    }

    /** Saves one file repeatedly until the studio is gone. Returns the number of confirmed saves. */
    private static int save(StudioProcess studio, String place, CountDownLatch saved) {
        String version = "";
        for (int save = 0; true; save++) {
            try {
                String answer = studio.ask("PUT", place, text(save), "Replace: yes", "Known-Version: " + version);
                if (!answer.startsWith("HTTP/1.1 200")) {
                    assertThat(answer).isEmpty();
                    return save;
                }
                version = version(answer);
                saved.countDown();
            } catch (IOException killed) {
                return save;
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {30, 61})
    void everyFileIsTheFormerOrTheNewOne(int saves) throws Exception {
        CountDownLatch saved = new CountDownLatch(saves);
        List<Future<Integer>> counts = new ArrayList<>();
        ExecutorService threads = Executors.newFixedThreadPool(PLACES.size());
        try (StudioProcess studio = StudioProcess.start(folder)) {
            for (String place : PLACES) {
                counts.add(threads.submit(() -> save(studio, place, saved)));
            }
            saved.await();
            studio.kill();
        } finally {
            threads.shutdown();
        }

        checkText(folder.resolve("Mine.java"), counts.get(0).get());
        checkText(folder.resolve("motions/mine.txt"), counts.get(1).get());
        assertThat(counts.get(2).get()).isPositive();
        checkScene(folder.resolve("scenes/mine.rec"));
        try (StudioProcess again = StudioProcess.start(folder)) {
            for (String list : List.of("files/program", "files/motion", "scenes")) {
                assertThat(again.ask("GET", list, ""))
                        .containsIgnoringCase("mine")
                        .doesNotContain(".part");
            }
            assertThat(again.ask("PUT", "scenes/mine", "", "Replace: yes")).startsWith("HTTP/1.1 200");
        }
    }

    private static void checkText(Path file, int saves) throws IOException {
        assertThat(saves).isPositive();
        assertThat(Files.readString(file).equals(text(saves - 1))
                        || Files.readString(file).equals(text(saves)))
                .as("%s is what was saved as number %d or %d", file, saves - 1, saves)
                .isTrue();
    }

    private static void checkScene(Path scene) throws IOException {
        try (RecordingReader reader = RecordingFile.read(scene)) {
            assertThat(reader.next()).isPresent();
        }
        Path state = scene.resolveSibling(scene.getFileName() + StateFile.ENDING);
        assertThat(Files.notExists(state) || StateFile.read(state).toBytes().length > 0)
                .isTrue();
    }
}
