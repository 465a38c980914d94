package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.IntStream;

/** Runs the tests of the pages, which are in {@code pages/studio/src/test/pages}, in a browser. */
final class PageTestRunner {

    /** Slow tests run in one process for each core of a small computer; the others would wait longer for a second browser. */
    private static final int PROCESSES_OF_SLOW_TESTS = 2;

    /** More parts than processes, so that no process has much more to do than the other. */
    private static final int PARTS_OF_SLOW_TESTS = 6;

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
        boolean isSlow = tests.equals("slow");
        int parts = isSlow ? PARTS_OF_SLOW_TESTS : 1;
        ExecutorService processes = Executors.newFixedThreadPool(isSlow ? PROCESSES_OF_SLOW_TESTS : 1);
        try {
            List<Callable<String>> all = IntStream.rangeClosed(1, parts)
                    .<Callable<String>>mapToObj(
                            part -> () -> failuresOf(folder, tests, part + "/" + parts, environment))
                    .toList();
            for (Future<String> failures : processes.invokeAll(all)) {
                assertThat(failures).succeedsWithin(Duration.ZERO).asString().isEmpty();
            }
        } finally {
            processes.shutdownNow();
        }
    }

    /** Runs a part of the tests, and returns what it prints about the failing ones; empty if all pass. */
    private static String failuresOf(String folder, String tests, String part, Map<String, String> environment)
            throws IOException, InterruptedException {
        Path output = Files.createTempFile("pages", ".txt");
        boolean isPassed = start(folder, tests, part, environment, output).waitFor() == 0;
        String printed = Files.readString(output);
        Files.delete(output);
        return isPassed ? "" : "failed: " + printed.substring(Math.max(0, printed.indexOf("failing tests:")));
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
