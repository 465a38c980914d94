package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

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

    private static void run(String tests) throws IOException, InterruptedException {
        Tool.BROWSER.orSkip();
        NodeTool.require("puppeteer-core");
        ProcessBuilder builder = new ProcessBuilder(
                Tool.NODE.orSkip().toString(), PAGES.resolve("all.js").toString(), "rooms");
        builder.environment().put("TESTS", tests);
        builder.environment()
                .put(
                        "STAGE_CLASS_PATH",
                        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")));
        Process process = builder.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
    }
}
