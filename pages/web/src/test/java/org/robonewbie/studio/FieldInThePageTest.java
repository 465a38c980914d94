package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The field of the static page: changes of the world can be undone, scenes are stored, and robots are steered by hand. */
@InBrowser
@Timeout(300)
class FieldInThePageTest {

    private static final String SAYS = "document.querySelector('#toast').textContent === ";
    private static final String NEXT = "document.querySelector('#world-undo').title === ";
    private static final String BALL = "studio.state.frame.ball";
    private static final String TORSO = "studio.state.frame.robots[0].torso";

    private static final String STATE =
            "[..." + BALL + ", ..." + TORSO + ", ...studio.state.frame.robots[0].degrees].join()";

    private static final String SLIDER =
            "document.querySelector('#puppet-joints input[data-joint=LEFT_SHOULDER_PITCH]')";
    private static final String ANGLE = "studio.state.frame.robots[1].degrees[studio.state.scene.models.TYPE_0.hinges"
            + ".findIndex(hinge => hinge.joint === 'LEFT_SHOULDER_PITCH')]";

    private final Chromium browser;
    private StaticServer server;

    FieldInThePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        server = new StaticServer(Path.of("target", "web").toAbsolutePath());
        browser.visit(server.address());
        browser.await("studio.state.frame.cycle > 100");
        browser.evaluate("navigator.serviceWorker.ready.then(() => true)");
        server.close();
    }

    @AfterEach
    void end() {
        server.close();
    }

    @Test
    void ballAndRobotThatWereMovedAreBackToTheBit() {
        pause();
        String before = state();
        for (int place = 1; place <= 5; place++) {
            send("{do: 'placeBall', gesture: 7, x: " + place + ", y: 1, z: 0.042}");
        }
        browser.await(NEXT + "'Undo: ball moved (Ctrl+Z)' && Math.abs(" + BALL + "[0] - 5) < 0.01");
        send("{do: 'placeRobot', side: 'left', number: 1, x: -2, y: 1.5, z: 0.4, headingDegrees: 90}");
        browser.await(NEXT + "'Undo: robot moved (Ctrl+Z)' && Math.abs(" + TORSO + "[1] - 1.5) < 0.1");

        browser.click("#world-undo");
        browser.await(SAYS + "'Undone: robot moved.'");
        browser.evaluate(
                "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true}))");
        browser.await(SAYS + "'Undone: ball moved.'");

        browser.await("(" + STATE + ") === '" + before + "'");
        browser.click("#world-redo");
        browser.await(SAYS + "'Redone: ball moved.' && Math.abs(" + BALL + "[0] - 5) < 0.01");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void sceneSurvivesAReloadAndIsRestoredExactly() {
        pause();
        send("{do: 'placeBall', gesture: 7, x: 1, y: 1, z: 0.042}");
        browser.await("Math.abs(" + BALL + "[0] - 1) < 0.01");
        String kept = state();
        browser.fill("#scene-name", "Corner");
        browser.click("#scene-save");
        browser.await("document.querySelector('#scene-list').value === 'Corner'");

        browser.visit("about:blank");
        browser.visit(server.address());
        browser.await("document.querySelector('#scene-list')?.value === 'Corner' && studio.state.frame.cycle > 100");
        browser.click("#scene-restore");

        browser.await("studio.state.frame.paused && (" + STATE + ") === '" + kept + "'");
        browser.await(
                SAYS + "'The world was restored exactly. Agents are not restored: they keep what they remember.'");
        browser.await(NEXT + "'Undo: scene loaded (Ctrl+Z)'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void sceneIsRenamedDeletedAndRestored() {
        browser.fill("#scene-name", "Before the kick");
        browser.click("#scene-save");
        browser.await("document.querySelector('#scene-list').value === 'Before the kick'");
        browser.fill("#scene-name", "Free kick");
        browser.click("#scene-rename");
        browser.await("document.querySelector('#scene-list').value === 'Free kick'");
        browser.click("#scene-remove");
        browser.await("document.querySelector('#scene-list').options.length === 0");

        browser.click("#world-undo");

        browser.await("document.querySelector('#scene-list').value === 'Free kick'");
        browser.click("#world-undo");
        browser.await("document.querySelector('#scene-list').value === 'Before the kick'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void worldContinuesFromTheShownCycleOfItsRecording() {
        send("{do: 'placeBall', gesture: 7, x: 3, y: 2, z: 0.042}");
        browser.await("Math.abs(" + BALL + "[0] - 3) < 0.01");
        browser.evaluate("fetch('api/recordings').then((answer) => answer.json()).then(({ recordings }) => {"
                + " location.hash = '#replay/' + encodeURIComponent(recordings[0].name); })");
        browser.await("studio.replay?.state?.count > 100");
        browser.evaluate("studio.replay.actions.find((action) => action.shown === 'Home').act()");
        browser.await("studio.replay.state.index === 0");
        browser.click("#start-here");

        browser.await("location.hash === '#field' && studio.state.frame.paused && Math.hypot(" + BALL + "[0], " + BALL
                + "[1]) < 0.01");
        browser.await(
                "document.querySelector('#toast').textContent.includes('The world was restored only approximately')");
        browser.click("#world-undo");
        browser.await("Math.abs(" + BALL + "[0] - 3) < 0.3");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void puppetIsSteeredBySlidersAndKeysAndRemoved() {
        browser.click("#add-puppet");
        browser.await("studio.state.scene.robots[1]?.puppet && studio.camera.chosen === 1");
        browser.await(NEXT + "'Undo: puppet added (Ctrl+Z)'");

        browser.evaluate("document.querySelector('#puppet-joints').open = true");
        browser.await(SLIDER);
        browser.evaluate(SLIDER + ".value = '80'; " + SLIDER + ".dispatchEvent(new Event('input'))");
        browser.await("Math.abs(" + ANGLE + " - 80) < 1");
        press("keydown", "w");
        browser.await("Math.abs(" + ANGLE + " - 80) > 20");
        press("keyup", "w");
        browser.click("#remove-puppet");
        browser.await("studio.state.scene.robots.length === 1");
        browser.click("#world-undo");

        browser.await(SAYS + "'Undone: puppet removed.' && studio.state.scene.robots[1]?.puppet");
        assertThat(browser.complaints()).isEmpty();
    }

    private void press(String kind, String key) {
        browser.evaluate(
                "document.dispatchEvent(new KeyboardEvent('" + kind + "', {key: '" + key + "', bubbles: true}))");
    }

    private String state() {
        return browser.evaluate(STATE).getAsString();
    }

    private void pause() {
        browser.click("#toggle");
        browser.await("studio.state.frame.paused");
    }

    private void send(String command) {
        browser.evaluate("studio.send(" + command + ")");
    }
}
