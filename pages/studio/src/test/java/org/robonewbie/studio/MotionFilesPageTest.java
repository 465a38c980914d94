package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.simulator.file.RecordingRepository;

/** Import and export of motions: files of Webots, a recorded run, and recovery after the browser was killed. */
@Tag("slow")
@InBrowser
class MotionFilesPageTest {

    private static final String STATE = "studio.motion.editor.state";
    private static final String FRAMES =
            STATE + ".history.present.value.lines.filter(line => line.keyframe).map(line => line.keyframe)";
    private static final String TWO_KEYFRAMES = """
            500 0 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25
            1000 0 12.5 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25
            """;

    @TempDir
    private Path folder;

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator().withRobot();
    private StudioServer studio;

    MotionFilesPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        RecordedRun.write(folder.resolve("game.rec"));
        Files.writeString(folder.resolve("mine.txt"), TWO_KEYFRAMES);
        RecordingRepository repository = new RecordingRepository(folder, 1_000_000);
        studio = StudioServer.start(
                simulation.control(), 0, AccessToken.random(), new StudioFolders(folder, Optional.of(repository)));
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void visitMotion(Chromium page) {
        page.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#motion/mine");
        page.await("studio.motion && " + STATE + ".name === 'mine' && " + FRAMES + ".length === 2");
        page.await("!studio.motion.stale");
    }

    private String text(String expression) {
        return browser.evaluate(expression).getAsString();
    }

    @Test
    void motionIsExportedToWebotsAndImported() {
        visitMotion(browser);
        String before = text("JSON.stringify(" + FRAMES + ")");
        browser.evaluate("(() => { const make = URL.createObjectURL;"
                + " URL.createObjectURL = blob => { window.given = blob; return make(blob); };"
                + " HTMLAnchorElement.prototype.click = function () { window.givenName = this.download; }; })()");

        browser.click("#export");
        browser.await("document.querySelector('#answer').value === 'webots'");
        browser.click("#accept");
        browser.await("window.given");
        String webots = text("window.given.text()");
        browser.evaluate("HTMLInputElement.prototype.click = function () { const choice = new DataTransfer();"
                + " choice.items.add(new File([" + Chromium.quoted(webots) + "], 'theirs.motion'));"
                + " this.files = choice.files; this.dispatchEvent(new Event('change')); }");
        browser.click("#import");
        browser.await(STATE + ".name !== 'mine' && " + FRAMES + ".length === 2");

        assertThat(text("window.givenName")).isEqualTo("mine.motion");
        assertThat(webots).startsWith("#WEBOTS_MOTION,V1.0,HeadYaw,HeadPitch,").contains("Pose2");
        assertThat(text("JSON.stringify(" + FRAMES + ")")).isEqualTo(before);
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void workIsRecoveredAfterTheBrowserWasKilled() throws IOException {
        try (Chromium killed = Chromium.open(1366, 768)) {
            visitMotion(killed);
            killed.fill("[data-joint='NECK_PITCH']", "7.5");
            Path draft = folder.resolve(".studio").resolve("drafts").resolve("mine.txt");
            simulation.awaitTrue(() -> Files.exists(draft));
        }

        visitMotion(browser);

        browser.await(FRAMES + "[0].degrees[1] === 7.5");
        assertThat(Files.readString(folder.resolve("mine.txt"))).isEqualTo(TWO_KEYFRAMES);
    }

    @Test
    void postureOfARecordedMomentBecomesAKeyframe() {
        browser.visit(studio.oneTimeAddress() + "&quality=lowest&theme=light#replay/game");
        browser.await("studio.replay?.file?.isWhole && studio.cursor.recorded && !studio.replay.stale");
        browser.evaluate("studio.replay.actions.find(action => action.shown === 'End').act()");
        browser.await("studio.replay.state.index === studio.replay.state.count - 1 && !studio.replay.stale");
        String knee = "studio.state.scene.models.TYPE_0.hinges.findIndex(hinge => hinge.joint === 'LEFT_KNEE_PITCH')";
        browser.await("studio.cursor.recorded.frame.robots.length === 1");
        double recorded = browser.evaluate("studio.cursor.recorded.frame.robots[0].degrees[" + knee + "]")
                .getAsDouble();

        browser.evaluate("location.hash = '#motion/mine'");
        browser.await("studio.motion && " + STATE + ".name === 'mine' && " + FRAMES + ".length === 2");
        browser.click("#take-posture");
        browser.await(FRAMES + ".length === 3");

        double taken = browser.evaluate(FRAMES + "[1].degrees[9]").getAsDouble();
        assertThat(taken).isCloseTo(recorded, within(0.01));
    }
}
