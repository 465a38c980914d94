package org.robonewbie.studio;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.robonewbie.examples.Agent_BetterSoccer;

/**
 * Measures the static page for {@code docs/web.md}. Not part of the usual tests, since it measures the computer: {@code
 * -Dtest=PageMeasurement}, with the page served at port 8000 by {@code python3 -m http.server -d pages/web/target/web}.
 */
@InBrowser
class PageMeasurement {

    private static final int OPENINGS = 6;
    private static final int RUNS = 4;
    private static final int SLIDES = 20;
    private static final int SECONDS = 60;
    private static final int CYCLES_PER_SECOND = 50;

    private static final String OPENED = """
            new Promise((done) => {
              let robot = 0;
              const look = () => {
                const frame = window.studio?.state.frame;
                if (!robot && document.querySelector('#stage[data-drawn]') && frame?.robots.length) {
                  robot = performance.now();
                }
                if (robot && frame.cycle >= 60) {
                  const paint = performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN;
                  done([paint, robot, performance.now()].join());
                } else {
                  requestAnimationFrame(look);
                }
              };
              look();
            })
            """;

    private static final String RUN = """
            new Promise((done) => {
              window.runner ??= new Worker('world-worker.js', { type: 'module' });
              const begin = performance.now();
              window.runner.onmessage = () => done(performance.now() - begin);
              window.runner.postMessage({ call: { name: 'recordingSha256', given: ['Agent_BetterSoccer', SEED, LENGTH] } });
            })
            """;

    private static final String SLIDING = """
            import org.robonewbie.agent.Agent;
            public class MyAgent extends Agent {
                private final double gain = number("gain", 0.5, 0, 1);
                protected void think() { nao.plot("gain", gain); }
            }
            """;

    private static final String SLIDE = """
            new Promise((done) => {
              const room = studio.rooms.program;
              const hear = Object.getPrototypeOf(room).hear;
              const begin = performance.now();
              room.hear = (news) => {
                if (news.lines.some((line) => line.startsWith('plot') && line.endsWith('\\tVALUE'))) {
                  delete room.hear;
                  done(performance.now() - begin);
                }
                hear.call(room, news);
              };
              const slider = document.querySelector('#program-sliders input');
              slider.value = 'VALUE';
              slider.dispatchEvent(new Event('input'));
            })
            """;

    private final Chromium browser;

    PageMeasurement(Chromium browser) {
        this.browser = browser;
    }

    /** The address of the page; each number is a separate origin for which the browser has nothing cached. */
    private static String page(int number) {
        return "http://127.0.0." + number + ":8000/";
    }

    @Test
    void secondsUntilTheRobotMoves() {
        browser.resize(1366, 768);
        browser.drawSharply();
        double[][] opened = new double[OPENINGS][];
        double empty = memoryOfPages();
        for (int i = 0; i < OPENINGS; i++) {
            browser.visit(page(i + 1));
            opened[i] = Arrays.stream(browser.evaluate(OPENED).getAsString().split(",", -1))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            print("memory of so many pages: %.0f, %.0f MB", i + 1.0, (memoryOfPages() - empty) / 1e6);
            browser.visit("about:blank");
        }
        report("first paint", IntStream.range(0, OPENINGS).mapToDouble(i -> opened[i][0]));
        report("robot in the picture", IntStream.range(0, OPENINGS).mapToDouble(i -> opened[i][1]));
        report("cycle 60", IntStream.range(0, OPENINGS).mapToDouble(i -> opened[i][2]));
    }

    @Test
    void cyclesPerSecondInThePageAndOnTheJvm() {
        browser.visit(page(OPENINGS + 1) + "webassembly-loader.js");
        for (int i = 1; i <= RUNS; i++) {
            String run = RUN.replace("SEED", "" + i).replace("LENGTH", "" + SECONDS);
            double there = browser.evaluate(run).getAsDouble() / 1000;
            long begin = System.nanoTime();
            new Agent_BetterSoccer().run("--headless", "--fast", "--seed", "" + i, "--seconds", "" + SECONDS);
            double here = (System.nanoTime() - begin) / 1e9;
            print(
                    "page %.2f s, %.0f cycles/s; JVM %.2f s, %.0f cycles/s",
                    there, SECONDS * CYCLES_PER_SECOND / there, here, SECONDS * CYCLES_PER_SECOND / here);
        }
        browser.visit("about:blank");
    }

    @Test
    void millisecondsFromASliderToTheRobot() {
        browser.resize(1366, 768);
        browser.drawSharply();
        double empty = memoryOfPages();
        browser.visit(page(OPENINGS + 2) + "#program");
        browser.await("studio.rooms.program?.files?.file !== undefined");
        browser.evaluate("studio.rooms.program.editor.replace(" + Chromium.quoted(SLIDING) + ")");
        browser.click("#program-run");
        browser.await("document.querySelector('#program-values').innerText.includes('gain 0.5')");
        browser.await("document.querySelector('#program-sliders input') !== null");
        report(
                "from slider to robot",
                IntStream.rangeClosed(1, SLIDES)
                        .mapToDouble(i -> browser.evaluate(SLIDE.replace("VALUE", "0." + (i % 2 == 0 ? 2 : 7)))
                                .getAsDouble()));
        print("memory of the page with its compiler: %.0f MB", (memoryOfPages() - empty) / 1e6);
        browser.visit("about:blank");
    }

    private static void report(String what, DoubleStream milliseconds) {
        double[] sorted = milliseconds.sorted().toArray();
        print(
                what + ": median %.0f ms (%.0f to %.0f, %.0f times)",
                sorted[sorted.length / 2],
                sorted[0],
                sorted[sorted.length - 1],
                (double) sorted.length);
    }

    private static void print(String format, Object... values) {
        System.out.printf(
                Locale.ROOT,
                format + ", load %.1f%n",
                DoubleStream.concat(
                                Arrays.stream(values).mapToDouble(value -> (Double) value),
                                DoubleStream.of(ManagementFactory.getOperatingSystemMXBean()
                                        .getSystemLoadAverage()))
                        .boxed()
                        .toArray());
    }

    /**
     * Private memory of the browser's processes for pages and workers in bytes; on Linux only. The browser keeps pages in memory after
     * they are left, so a memory measurement needs its own browser: {@code -Dtest=PageMeasurement#millisecondsFromASliderToTheRobot}.
     */
    private static double memoryOfPages() {
        return ProcessHandle.current()
                .descendants()
                .map(process -> Path.of("/proc", Long.toString(process.pid())))
                .filter(process -> text(process.resolve("cmdline")).contains("--type=renderer"))
                .flatMap(process -> text(process.resolve("smaps_rollup")).lines())
                .filter(line -> line.startsWith("Pss:"))
                .mapToDouble(line -> Double.parseDouble(line.replaceAll("[^0-9]", "")) * 1024)
                .sum();
    }

    private static String text(Path file) {
        return Optional.of(file)
                .map(path -> {
                    try {
                        return Files.readString(path);
                    } catch (IOException gone) {
                        return "";
                    }
                })
                .orElse("");
    }
}
