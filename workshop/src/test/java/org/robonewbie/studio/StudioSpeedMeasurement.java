package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/**
 * Measures the frame rate of a browser without a graphics card for one and for 22 robots, at the quality that the studio selects and at
 * medium quality, and the cost of each, for {@code docs/performance.md}. Not part of the usual tests, since it measures the computer:
 * {@code -Dtest=StudioSpeedMeasurement}.
 */
class StudioSpeedMeasurement {

    private static final int SETTLING_SECONDS = 25;
    private static final int MEASURED_SECONDS = 15;
    private static final String COUNT_PICTURES = "(() => { const view = studio.view; const draw = view.draw.bind(view);"
            + " window.pictures = 0; view.draw = () => { window.pictures++; draw(); }; })()";

    @ParameterizedTest
    @CsvSource({"1, ''", "22, ''", "22, medium"})
    void picturesPerSecond(int robots, String quality) throws IOException {
        Tool.BROWSER.orSkip();
        try (TestSimulator simulation = match(robots);
                StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
                Chromium browser = Chromium.open(1280, 720)) {
            browser.visit(studio.oneTimeAddress() + "&theme=light" + (quality.isEmpty() ? "" : "&quality=" + quality));
            browser.await("studio.state.scene?.robots.length === " + robots
                    + " && studio.state.frame && studio.view.drawCalls > 0");
            browser.evaluate("studio.camera.setMode('free')");
            browser.rest(SETTLING_SECONDS);
            browser.evaluate(COUNT_PICTURES);
            long cycle = simulation.latest().cycle();
            double work = browser.processorSeconds();
            long start = System.nanoTime();
            browser.rest(MEASURED_SECONDS);
            double seconds = (System.nanoTime() - start) / 1e9;
            int pictures = browser.evaluate("window.pictures").getAsInt();
            double factor = (simulation.latest().cycle() - cycle) * 0.02 / seconds;
            int calls = browser.evaluate("studio.view.drawCalls").getAsInt();
            System.out.printf(
                    Locale.ROOT,
                    "%d robots at 1280x720: %.1f pictures/s, %.0f ms of processors each, quality %s, %d draw calls,"
                            + " %d triangles, %.2f times real time, load %.1f%n",
                    robots,
                    pictures / seconds,
                    1000 * (browser.processorSeconds() - work) / Math.max(1, pictures),
                    browser.evaluate("studio.chooser.quality.name").getAsString(),
                    calls,
                    browser.evaluate("studio.view.renderer.info.render.triangles")
                            .getAsInt(),
                    factor,
                    ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
            assertThat(calls).isBetween(1, 100);
        }
    }

    static TestSimulator match(int robots) {
        TestSimulator simulation = new TestSimulator();
        for (int i = 0; i < robots; i++) {
            TeamSide side = i < 11 ? TeamSide.LEFT : TeamSide.RIGHT;
            int sign = side == TeamSide.LEFT ? -1 : 1;
            int row = i % 11 / 3;
            double x = sign * (0.8 + 1.2 * row);
            double y = 1.6 * (i % 11 % 3 - 1);
            double heading = side == TeamSide.LEFT ? 0 : 180;
            simulation.withRobot(RobotType.TYPE_0, side, i % 11 + 1, x, y, heading, Posture.STANDING);
        }
        return simulation;
    }
}
