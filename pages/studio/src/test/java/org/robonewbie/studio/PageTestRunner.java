package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;

/** Runs the tests of the pages, which are in {@code pages/studio/src/test/pages}, in a browser. */
final class PageTestRunner {

    private PageTestRunner() {}

    /**
     * Runs the tests of a folder; skips the calling test if Node.js, its packages or Chromium are missing.
     *
     * @param folder name of the folder
     * @param tests kind of tests, quick or slow
     * @param environment environment variables that say what is tested
     */
    static void run(String folder, String tests, Map<String, String> environment)
            throws IOException, InterruptedException {
        Tool.BROWSER.orSkip();
        NodeTool.require("puppeteer-core");
        String all = NodeTool.project().resolve("pages/studio/src/test/pages/all.js").toString();
        ProcessBuilder builder = new ProcessBuilder(Tool.NODE.orSkip().toString(), all, folder);
        builder.environment().put("TESTS", tests);
        builder.environment().putAll(environment);
        Process process = builder.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
    }
}
