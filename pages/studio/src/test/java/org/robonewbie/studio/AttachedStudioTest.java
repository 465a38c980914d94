package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.studio.monitor.MonitoredSimulation;

/** The studio attached to a foreign simulation: a server with a monitor port, or a given recording. */
@Tag("slow")
@InBrowser
class AttachedStudioTest {

    private static final String NO_CLOCK = "The watched server has its own clock; a monitor cannot stop it.";

    @TempDir
    private Path folder;

    private final Chromium browser;

    AttachedStudioTest(Chromium browser) {
        this.browser = browser;
    }

    @Test
    void serverIsSeenThroughItsMonitorPortAndItsClockIsLeftAlone() throws IOException {
        RecordedRun.write(folder.resolve("game.rec"));
        StudioFolders folders = new StudioFolders(
                folder.resolve("motions"), Optional.of(new RecordingRepository(folder, 1_000_000_000)));
        try (PlayingRobot robot = PlayingRobot.start(OptionalInt.of(0));
                MonitoredSimulation watched = MonitoredSimulation.connect(
                        "127.0.0.1", robot.simulator().monitorPort().orElseThrow());
                StudioServer studio = StudioServer.start(watched, 0, AccessToken.random(), folders)) {
            browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light");
            browser.await(
                    "studio.state.scene?.robots.length === 1 && studio.view.robots.meshes.some(mesh => mesh.visible)");
            browser.await("document.querySelector('.team.left').textContent === 'Stars'");

            browser.await("document.querySelector('#no-clock').offsetParent !== null");
            for (String control : List.of("toggle", "step", "speed")) {
                String element = "document.querySelector('#" + control + "')";
                browser.await(element + ".disabled && " + element + ".title === " + Chromium.quoted(NO_CLOCK));
            }
            browser.await("document.querySelector('#puppet').hidden && document.querySelector('#scenes').hidden");
            browser.press(" ");
            browser.await(
                    "document.querySelector('#toast').textContent.startsWith('A simulation in another process cannot be paused')");
            browser.click("#drop-ball");
            browser.await("document.querySelector('.mode').textContent === 'Play on'");

            browser.evaluate("location.hash = '#replay/game'");
            browser.await("studio.replay?.file?.isWhole && document.querySelector('#start-here').title === "
                    + Chromium.quoted(NO_CLOCK));
            assertThat(browser.evaluate("document.querySelector('#start-here').disabled")
                            .getAsBoolean())
                    .isTrue();
            assertThat(browser.complaints()).isEmpty();
        }
    }

    @Test
    void recordingThatIsOpenedByItsNameIsShownAtOnce() throws IOException {
        Path file = folder.resolve("my game.rec");
        RecordedRun.write(file);
        StudioFolders folders = new StudioFolders(folder.resolve("motions"), Optional.empty()).withRecording(file);
        try (TestSimulator simulation = new TestSimulator();
                StudioServer studio = StudioServer.start(simulation.control(), 0, AccessToken.random(), folders)) {
            browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay/my%20game");

            browser.await("studio.replay?.file?.name === 'my game' && studio.replay.file.isWhole");
            browser.await("studio.view.robots.poses.length === 1 && studio.view.drawCalls > 0");
            browser.click("#replay-play");
            browser.await("studio.replay.state.index > 20");
            assertThat(browser.complaints()).isEmpty();
        }
    }
}
