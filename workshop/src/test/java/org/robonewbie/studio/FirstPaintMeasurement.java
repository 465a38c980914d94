package org.robonewbie.studio;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/**
 * Measures the time to the first paint of the page and to the first frame of the field in a browser without a graphics card, for
 * {@code docs/performance.md}: in a JVM that has just started, which is the first line, and in a warm one; each in a browser with an empty
 * cache, and again in the same browser. Not part of the usual tests, since it measures the computer:
 * {@code -Dtest=FirstPaintMeasurement}.
 */
class FirstPaintMeasurement {

    private static final int STARTS = 5;
    private static final String WATCH_PICTURES = "(function look() { if (window.studio?.view.drawCalls > 0) {"
            + " window.firstPicture = performance.now(); } else { requestAnimationFrame(look); } })()";
    private static final String FIRST_PAINT = "performance.getEntriesByName('first-contentful-paint')[0]";

    @Test
    void millisecondsToTheFirstPaint() throws IOException {
        Tool.BROWSER.orSkip();
        for (int start = 0; start < STARTS; start++) {
            try (Chromium browser = Chromium.open(1366, 768);
                    TestSimulator simulation = new TestSimulator().withRobot();
                    StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random())) {
                browser.rest(1);
                browser.runBeforePages(WATCH_PICTURES);
                report(start == 0 ? "cold Java" : "warm Java", browser, studio);
                report("seen before", browser, studio);
            }
        }
    }

    private static void report(String occasion, Chromium browser, StudioServer studio) {
        browser.visit("about:blank");
        browser.visit(studio.oneTimeAddress().toString());
        browser.await("window.firstPicture && " + FIRST_PAINT);
        System.out.printf(
                Locale.ROOT,
                "%s: answered after %.0f ms, first paint after %.0f ms, scripts there after %.0f ms, first picture after"
                        + " %.0f ms, load %.1f%n",
                occasion,
                browser.evaluate("performance.getEntriesByType('navigation')[0].responseEnd")
                        .getAsDouble(),
                browser.evaluate(FIRST_PAINT + ".startTime").getAsDouble(),
                browser.evaluate("performance.getEntriesByType('navigation')[0].domContentLoadedEventStart")
                        .getAsDouble(),
                browser.evaluate("window.firstPicture").getAsDouble(),
                ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
    }
}
