package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.motion.file.MotionFiles;

/** Monkey test with random clicks, keys and drags in each room: no errors occur, and no file is lost or corrupted. */
@Tag("slow")
@InBrowser
class FuzzPageTest {

    private static final long SEED = 20261122;
    private static final int STEPS_PER_CALL = 500;
    private static final int MAX_HEAP_BYTES = 300_000_000;

    /** Steps with native mouse and key events, which change focus and scroll as a user's do, but are slow. */
    private static final int REAL_STEPS = 25;

    /** Expected refusals, which are not errors: invalid name (400), missing recording (404), name in use (409). */
    private static final Pattern REFUSED = Pattern.compile("the server responded with a status of 4(00|04|09)");

    @TempDir
    private Path folder;

    private final Chromium browser;
    private FurnishedStudio studio;
    private byte[] recording = {};

    FuzzPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = new FurnishedStudio(folder);
        recording = Files.readAllBytes(folder.resolve("game.rec"));
        Files.writeString(folder.resolve("Student.java"), "// mine");
    }

    @AfterEach
    void close() {
        studio.close();
    }

    @ParameterizedTest
    @ValueSource(strings = {"#field", "#field/exercises", "#program", "#robot", "#motion/mine", "#replay/game"})
    void fiveHundredStepsLeaveNoErrorAndLoseNoFile(String room) throws IOException {
        fuzz(room, 500);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"#field", "#field/exercises", "#program", "#robot", "#motion/mine", "#replay/game"})
    void tenThousandStepsLeaveNoErrorAndLoseNoFile(String room) throws IOException {
        fuzz(room, 10_000);
    }

    private void fuzz(String room, int steps) throws IOException {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light" + room);
        browser.await("studio.state.scene.robots.length === 1 && document.querySelector('" + isThere(room) + "')");
        Random random = new Random(SEED);
        for (int i = 0; i < REAL_STEPS; i++) {
            reallyStep(random);
        }
        browser.evaluate(Files.readString(Path.of("src/test/tools/fuzz-page.js"), StandardCharsets.UTF_8) + "; true");
        for (int done = 0; done < steps; done += STEPS_PER_CALL) {
            browser.evaluate("fuzz(" + random.nextInt(Integer.MAX_VALUE) + ", " + STEPS_PER_CALL + ", '" + room + "')");
            assertNothingFailed("after " + (done + STEPS_PER_CALL) + " steps");
        }

        assertFilesAreSafe();
    }

    private static String isThere(String room) {
        return switch (room) {
            case "#field/exercises" -> "[data-exercise=kick]";
            case "#program" -> "#program-save";
            case "#robot" -> ".joint-row";
            case "#motion/mine" -> ".keyframe";
            case "#replay/game" -> "#replay:not([hidden])";
            default -> "#toggle:not([disabled])";
        };
    }

    private void reallyStep(Random random) {
        if (random.nextInt(3) == 0) {
            browser.press(Character.toString("abcdefghijklmnopqrstuvwxyz0123456".charAt(random.nextInt(33))));
            return;
        }
        double x = random.nextInt(1366);
        double y = 60 + random.nextInt(700);
        browser.mouse("mousePressed", x, y);
        browser.mouse("mouseMoved", x + random.nextInt(-60, 60), y + random.nextInt(-60, 60));
        browser.mouse("mouseReleased", x, y);
    }

    private void assertNothingFailed(String when) {
        List<String> errors = browser.complaints().stream()
                .filter(each -> !REFUSED.matcher(each).find())
                .toList();
        assertThat(errors).as(when).isEmpty();
        assertThat(browser.evaluate("performance.memory.usedJSHeapSize").getAsLong())
                .as("bytes of the heap " + when)
                .isLessThan(MAX_HEAP_BYTES);
    }

    /**
     * Recordings may have been renamed or deleted; motions may have changed but must be readable; typed text may have been saved to a
     * program.
     */
    private void assertFilesAreSafe() throws IOException {
        assertThat(folder.resolve("Student.java")).isNotEmptyFile();
        assertThat(MotionFiles.load(folder.resolve("mine.txt")).motion().keyframes())
                .isNotEmpty();
        try (Stream<Path> files = Files.walk(folder)) {
            assertThat(files.filter(each -> each.toString().contains(".rec"))
                            .filter(Files::isRegularFile)
                            .anyMatch(this::isTheRecording))
                    .as("the recording is somewhere")
                    .isTrue();
        }
    }

    private boolean isTheRecording(Path file) {
        try {
            return Files.size(file) == recording.length && Arrays.equals(Files.readAllBytes(file), recording);
        } catch (IOException e) {
            return false;
        }
    }
}
