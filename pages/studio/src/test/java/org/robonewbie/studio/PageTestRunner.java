package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Runs the tests of the pages, which are in {@code pages/studio/src/test/pages}, in a browser. */
final class PageTestRunner {

    /** Slow tests run in one process for each core of a small computer; the others would wait longer for a second browser. */
    private static final int PROCESSES_OF_SLOW_TESTS = 2;

    private PageTestRunner() {}

    /**
     * Runs the tests of a folder; skips the calling test if Node.js, its packages or Chromium are missing.
     *
     * @param folder name of the folder
     * @param tests kind of tests: quick, slow, picture or firefox
     * @param environment environment variables that say what is tested
     */
    static void run(String folder, String tests, Map<String, String> environment)
            throws IOException, InterruptedException {
        Tool.BROWSER.orSkip();
        NodeTool.require("puppeteer-core");
        int parts = tests.equals("slow") ? PROCESSES_OF_SLOW_TESTS : 1;
        List<Process> processes = new ArrayList<>();
        List<Path> outputs = new ArrayList<>();
        for (int part = 1; part <= parts; part++) {
            Path output = Files.createTempFile("pages", ".txt");
            outputs.add(output);
            processes.add(start(folder, tests, part + "/" + parts, environment, output));
        }
        for (Process process : processes) {
            process.waitFor();
        }
        for (int i = 0; i < parts; i++) {
            String said = Files.readString(outputs.get(i));
            Files.delete(outputs.get(i));
            String failing = said.substring(Math.max(0, said.indexOf("failing tests:")));
            assertThat(processes.get(i).exitValue()).as(failing).isZero();
        }
    }

    private static Process start(String folder, String tests, String part, Map<String, String> environment, Path output)
            throws IOException {
        String all =
                NodeTool.project().resolve("pages/studio/src/test/pages/all.js").toString();
        ProcessBuilder builder = new ProcessBuilder(Tool.NODE.orSkip().toString(), "--test-reporter=spec", all, folder);
        builder.environment().putAll(environment);
        builder.environment().putAll(Map.of("TESTS", tests, "PART", part));
        return builder.redirectErrorStream(true).redirectOutput(output.toFile()).start();
    }
}
