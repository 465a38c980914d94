package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs the tests of the studio's pages, which are in {@code pages/studio/src/test/pages/rooms}, in Chromium. */
class PagesTest {

    private static final Path PAGES = Path.of("..", "pages", "studio", "src", "test", "pages");

    @Test
    void roomsPassTheirQuickTests() throws IOException, InterruptedException {
        run("quick");
    }

    @Tag("slow")
    @Test
    void roomsPassTheirSlowTests() throws IOException, InterruptedException {
        run("slow");
    }

    @Tag("picture")
    @Test
    void roomsGiveThePicturesOfTheDocumentation(@TempDir Path pictures) throws IOException, InterruptedException {
        run("picture", pictures.toString());
        try (DirectoryStream<Path> files = Files.newDirectoryStream(pictures)) {
            for (Path file : files) {
                Picture.ofDocumentation("docs/images/" + file.getFileName(), Files.readAllBytes(file));
            }
        }
    }

    private static void run(String tests) throws IOException, InterruptedException {
        run(tests, "");
    }

    /** Runs tests that keep their pictures in a folder; nowhere if its name is empty. */
    private static void run(String tests, String pictures) throws IOException, InterruptedException {
        Tool.BROWSER.orSkip();
        NodeTool.require("puppeteer-core");
        ProcessBuilder builder = new ProcessBuilder(
                Tool.NODE.orSkip().toString(), PAGES.resolve("all.js").toString(), "rooms");
        builder.environment().put("TESTS", tests);
        builder.environment().put("PICTURES", pictures);
        builder.environment()
                .put(
                        "STAGE_CLASS_PATH",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")));
        Process process = builder.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
    }
}
