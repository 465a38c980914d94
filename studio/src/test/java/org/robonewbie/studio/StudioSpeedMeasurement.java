package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/**
 * Measures how many pictures per second a browser without graphics card draws of 22 robots, for {@code docs/performance.md}.
 * It is not part of the usual tests, since it judges the computer: {@code -Dtest=StudioSpeedMeasurement}.
 */
class StudioSpeedMeasurement {

    private static final int SETTLING_SECONDS = 25;
    private static final int MEASURED_SECONDS = 15;
    private static final String COUNT_PICTURES = "(() => { const view = studio.view; const draw = view.draw.bind(view);"
            + " window.pictures = 0; view.draw = () => { window.pictures++; draw(); }; })()";

    @Test
    void picturesOfTwentyTwoRobots() throws IOException {
        Tool.BROWSER.orSkip();
        try (SmallSimulation simulation = match();
                StudioServer studio = StudioServer.start(simulation.start(), 0, AccessToken.random());
                Chromium browser = Chromium.open(1280, 720)) {
            browser.visit(studio.address() + "&theme=light");
            browser.await(
                    "studio.state.scene?.robots.length === 22 && studio.state.frame && studio.view.drawCalls > 0");
            rest(SETTLING_SECONDS);
            browser.evaluate(COUNT_PICTURES);
            long cycle = simulation.latest().cycle();
            long start = System.nanoTime();
            rest(MEASURED_SECONDS);
            double seconds = (System.nanoTime() - start) / 1e9;
            double pictures = browser.evaluate("window.pictures").getAsInt() / seconds;
            double factor = (simulation.latest().cycle() - cycle) * 0.02 / seconds;
            int calls = browser.evaluate("studio.view.drawCalls").getAsInt();
            String quality = browser.evaluate("studio.chooser.quality.name").getAsString();
            System.out.printf(
                    Locale.ROOT,
                    "22 robots at 1280x720: %.1f pictures/s, quality %s, %d draw calls, %.2f times real time%n",
                    pictures,
                    quality,
                    calls,
                    factor);
            assertThat(calls).isLessThanOrEqualTo(100);
        }
    }

    private static SmallSimulation match() {
        SmallSimulation simulation = new SmallSimulation();
        for (int i = 0; i < 22; i++) {
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

    private static void rest(int seconds) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (System.nanoTime() < end) {
            LockSupport.parkNanos(50_000_000);
        }
    }
}
