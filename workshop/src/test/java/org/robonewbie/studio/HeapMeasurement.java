package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Measures the script heap of a page while 22 robots play for an hour and a user switches between the rooms, for
 * {@code docs/performance.md}. Not part of the usual tests, since it takes this hour: {@code -Dtest=HeapMeasurement}, with
 * {@code -Dstudio.minutes=N} for another duration.
 */
class HeapMeasurement {

    private static final int SECONDS_IN_A_ROOM = 20;
    private static final int MAX_BYTES = 80_000_000;
    private static final List<String> ROOMS =
            List.of("#field", "#robot", "#program", "#motion", "#replay", "#field/exercises");

    @TempDir
    private Path folder;

    @Test
    void bytesOfThePageAfterAnHour() throws IOException {
        Tool.BROWSER.orSkip();
        int seconds = 60 * Integer.getInteger("studio.minutes", 60);
        StudioFolders folders = new StudioFolders(folder, Optional.empty());
        try (TestSimulator simulation = StudioSpeedMeasurement.match(22);
                StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders);
                Chromium browser = Chromium.open(1366, 768)) {
            browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest");
            browser.await("studio.state.scene?.robots.length === 22 && studio.view.drawCalls > 0");
            System.out.printf(Locale.ROOT, "at the beginning: %.1f MB%n", browser.heapBytes() / 1e6);
            for (int visit = 0; visit * SECONDS_IN_A_ROOM < seconds; visit++) {
                browser.evaluate("location.hash = '" + ROOMS.get(visit % ROOMS.size()) + "'");
                browser.rest(SECONDS_IN_A_ROOM);
            }
            long bytes = browser.heapBytes();
            System.out.printf(Locale.ROOT, "after %d minutes: %.1f MB%n", seconds / 60, bytes / 1e6);
            assertThat(bytes).isLessThan(MAX_BYTES);
        }
    }
}
