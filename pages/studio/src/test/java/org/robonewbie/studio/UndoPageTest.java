package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All changes of the world can be undone exactly. */
@Tag("slow")
@InBrowser
class UndoPageTest {

    private static final String SAYS = "document.querySelector('#toast').textContent === ";
    private static final String NEXT = "document.querySelector('#world-undo').title === ";
    private static final String BALL = "studio.state.frame.ball";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private SteeredField field;

    UndoPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void openFieldWithAPuppet() throws IOException {
        field = new SteeredField(browser, folder);
        field.addPuppet();
        browser.await(NEXT + "'Undo: puppet added (Ctrl+Z)'");
        browser.click("#toggle");
        browser.await("studio.state.frame.paused");
    }

    @AfterEach
    void close() {
        field.close();
    }

    private void send(String command) {
        browser.evaluate("studio.send(" + command + ")");
    }

    private void undoByKeys() {
        browser.evaluate("document.activeElement.blur(); document.body.dispatchEvent(new KeyboardEvent('keydown',"
                + " {key: 'z', ctrlKey: true, bubbles: true}))");
    }

    private void redoByKeys() {
        browser.evaluate("document.body.dispatchEvent(new KeyboardEvent('keydown',"
                + " {key: 'Z', ctrlKey: true, shiftKey: true, bubbles: true}))");
    }

    @Test
    void dragOfTheBallIsOneStepThatIsUndoneToTheBit() {
        String before = browser.evaluate("[..." + BALL + "].join()").getAsString();
        for (int place = 1; place <= 5; place++) {
            send("{do: 'placeBall', gesture: 7, x: " + place + ", y: 1, z: 0.042}");
        }
        browser.await("Math.abs(" + BALL + "[0] - 5) < 0.01");

        undoByKeys();

        browser.await(SAYS + "'Undone: ball moved.'");
        browser.await("[..." + BALL + "].join() === '" + before + "'");
        browser.await(NEXT + "'Undo: puppet added (Ctrl+Z)'");
        redoByKeys();
        browser.await(SAYS + "'Redone: ball moved.' && Math.abs(" + BALL + "[0] - 5) < 0.01");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void turnedRobotPlayModeAndResetAreUndoneOneByOne() {
        send("{do: 'placeRobot', turn: true, side: 'left', number: 1, x: -2, y: 1, z: 0.4, headingDegrees: 90}");
        browser.await("Math.abs(studio.state.frame.robots[0].torso[1] - 1) < 0.1");
        browser.fill("#play-mode", "KickOff_Right");
        String mode = "studio.state.scene.playModes[studio.state.frame.playMode]";
        browser.await(mode + " === 'KickOff_Right'");
        browser.click("#reset");
        browser.await(NEXT + "'Undo: reset (Ctrl+Z)' && studio.state.frame.robots[0].torso[0] < -2.1");

        browser.click("#world-undo");
        browser.await(SAYS + "'Undone: reset.' && " + mode + " === 'KickOff_Right'"
                + " && Math.abs(studio.state.frame.robots[0].torso[1] - 1) < 0.1");
        browser.click("#world-undo");
        browser.await(SAYS + "'Undone: play mode changed.' && " + mode + " !== 'KickOff_Right'");
        browser.click("#world-undo");

        browser.await(SAYS + "'Undone: robot turned.' && Math.abs(studio.state.frame.robots[0].torso[1]) < 0.1");
    }

    @Test
    void runningClockKeepsRunningAfterUndo() {
        browser.click("#toggle");
        browser.await("!studio.state.frame.paused");
        send("{do: 'placeBall', gesture: 1, x: 3, y: 2, z: 0.042}");
        browser.await("Math.abs(" + BALL + "[0] - 3) < 0.01");

        undoByKeys();

        browser.await(SAYS + "'Undone: ball moved.' && " + BALL + "[0] < 1 && !studio.state.frame.paused");
    }

    @Test
    void removedPuppetReturnsToItsPosition() {
        browser.click("#toggle");
        browser.click("#add-puppet");
        browser.await("studio.state.scene.robots[1]?.side === 'left' && studio.state.frame.robots[1].torso[0] > -1.5");
        browser.await("studio.camera.chosen === 1");

        browser.click("#remove-puppet");
        browser.await("studio.state.scene.robots.length === 1");
        browser.await(NEXT + "'Undo: puppet removed (Ctrl+Z)'");
        browser.click("#world-undo");

        browser.await("studio.state.scene.robots.length === 2 && studio.state.frame.robots[1].torso[0] > -1.5");
        browser.click("#world-redo");
        browser.await("studio.state.scene.robots.length === 1");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void listKeepsTheKeyForUndoButAFieldHasItsOwn() {
        send("{do: 'placeBall', gesture: 1, x: 3, y: 2, z: 0.042}");
        browser.await(NEXT + "'Undo: ball moved (Ctrl+Z)'");

        String press = ".dispatchEvent(new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true,"
                + " cancelable: true}))";
        assertThat(browser.evaluate("document.querySelector('#scene-name')" + press)
                        .getAsBoolean())
                .isTrue();
        assertThat(browser.evaluate("document.querySelector('#play-mode')" + press)
                        .getAsBoolean())
                .isFalse();

        browser.await(SAYS + "'Undone: ball moved.'");
    }
}
