package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** All rooms in a browser without WebGL, such as that of a remote desktop. */
@InBrowser
class WithoutWebGlPageTest {

    private static final String NO_WEBGL = """
            const usual = HTMLCanvasElement.prototype.getContext;
            HTMLCanvasElement.prototype.getContext = function (kind, options) {
              return kind.startsWith('webgl') ? null : usual.call(this, kind, options);
            };
            """;

    /** Number of blue pixels, the colour of the left team, in a picture. */
    private static final String BLUE_PIXELS = """
            ((canvas) => {
              const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
              copy.drawImage(canvas, 0, 0);
              const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
              let count = 0;
              for (let i = 0; i < data.length; i += 4) {
                count += data[i + 2] > 100 && data[i + 2] > 2 * data[i] ? 1 : 0;
              }
              return count;
            })""";

    private final Chromium browser;
    private FurnishedStudio studio;
    private String script = "";

    WithoutWebGlPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void start(@TempDir Path folder) throws IOException {
        studio = new FurnishedStudio(folder);
        script = browser.runBeforePages(NO_WEBGL);
        browser.drawSharply();
    }

    @AfterEach
    void close() {
        browser.forgetScript(script);
        studio.close();
    }

    private void open(String room) {
        browser.visit(studio.oneTimeAddress() + "#" + room);
    }

    @Test
    void robotIsDrawnWithoutRealShadows() {
        open("field");

        browser.await("window.studio?.state.frame && 'drawn' in document.querySelector('#stage').dataset");
        browser.await(BLUE_PIXELS + "(studio.view.renderer.domElement) > 50");
        browser.await("document.querySelector('#banner').hidden");
        assertThat(browser.evaluate("document.querySelector('#shadows').closest('label').hidden")
                        .getAsBoolean())
                .isTrue();
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void draggedArmTurns() {
        open("motion/mine");
        browser.await("window.studio?.motion?.editor.state.name === 'mine' && !studio.motion.stale");
        browser.await(BLUE_PIXELS + "(studio.motion.stage.renderer.domElement) > 50");
        String[] arm = browser.evaluate(
                        "(() => { const room = studio.motion; const { posture, torso } = room.posedNow();"
                                + " const at = 7 * room.body.model.links.findIndex(({ name }) => name === 'llowerarm');"
                                + " return room.stage.pageAt([...room.posesOf(posture, torso)].slice(at, at + 3)).join(' '); })()")
                .getAsString()
                .split(" ", -1);
        double x = Double.parseDouble(arm[0]);
        double y = Double.parseDouble(arm[1]);

        browser.mouse("mousePressed", x, y);
        browser.mouse("mouseMoved", x + 5, y - 30);
        browser.mouse("mouseReleased", x + 5, y - 60);

        browser.await("studio.motion.editor.state.history.past.length > 0");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void recordingIsPlayed() {
        open("replay/game@play");

        browser.await("window.studio?.replay?.picture?.frame.cycle > 0");
        browser.await(BLUE_PIXELS + "(studio.view.renderer.domElement) > 50");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void programIsWrittenBesideTheRobot() {
        open("program");

        browser.await("window.studio?.rooms.program && document.querySelector('#program-save').checkVisibility()");
        browser.await(BLUE_PIXELS + "(studio.view.renderer.domElement) > 50");
        assertThat(browser.complaints()).isEmpty();
    }
}
