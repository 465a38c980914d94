package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The 3D view of the field shows the whole pitch beside the panels, at full resolution. */
@Tag("slow")
@InBrowser(width = 1440, height = 900)
class FieldPicturePageTest {

    private static final String CHEAP = "&quality=lowest";
    private static final String SEEN = "(x, y, z) => { const { view } = studio; const box ="
            + " view.stage.getBoundingClientRect(); const at = new view.camera.position.constructor(x, y, z)"
            + ".project(view.camera); return [box.left + (at.x + 1) / 2 * box.width,"
            + " box.top + (1 - at.y) / 2 * box.height]; }";
    private static final String IS_FREE = "(([x, y]) => x >= 0 && y >= 0 && x <= innerWidth && y <= innerHeight"
            + " && !document.elementFromPoint(x, y)?.closest('.panel, .bar'))";

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private StudioServer studio;

    FieldPicturePageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void start() throws IOException {
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void open(String options) {
        browser.visit(studio.oneTimeAddress() + "&theme=light" + options);
        browser.await("studio.state.frame && studio.camera.scene && studio.view.drawCalls > 0");
    }

    private void openWithRobot(String options) {
        simulation.withRobot();
        open(options);
        browser.await("studio.state.scene?.robots.length === 1 && studio.view.robots.poses[0]?.[2] > 0");
    }

    private boolean seesFreely(String points) {
        return browser.evaluate(points + ".every(point => " + IS_FREE + "((" + SEEN + ")(...point)))")
                .getAsBoolean();
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "3"})
    void wholePitchWithBothGoalsLiesBesideThePanels(String key) {
        openWithRobot(CHEAP);

        browser.press(key);
        browser.await("studio.camera.isStill && studio.camera.mode !== 'follow'");

        assertThat(seesFreely("[[-6, -4, 0], [6, -4, 0], [-6, 4, 0], [6, 4, 0], [6.6, 1, 0], [-6.6, -1, 0]]"))
                .isTrue();
    }

    @Test
    void pictureThatStandsStillHasAllPixels() {
        openWithRobot("");
        browser.await("!studio.view.isFine");

        browser.click("#toggle");

        browser.await("studio.view.isFine");
        String canvas = "studio.view.renderer.domElement";
        assertThat(browser.evaluate(canvas + ".width / " + canvas + ".clientWidth")
                        .getAsDouble())
                .isEqualTo(2);
        browser.click("#toggle");
        browser.await("!studio.view.isFine && " + canvas + ".width < 1.5 * " + canvas + ".clientWidth");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void pageBeforeTheFirstPictureIsNotBlack() {
        String script = browser.runBeforePages("window.requestAnimationFrame = () => 0");
        try {
            browser.visit(studio.oneTimeAddress() + "&theme=light" + CHEAP);

            browser.await("window.studio && document.querySelector('#stage-opening').checkVisibility()");
            browser.await("document.querySelector('#stage canvas')"
                    + " && getComputedStyle(document.querySelector('#stage canvas')).visibility === 'hidden'");
            assertThat(browser.evaluate("getComputedStyle(document.querySelector('#stage')).backgroundColor")
                            .getAsString())
                    .isEqualTo("rgb(223, 232, 239)");
        } finally {
            browser.forgetScript(script);
        }
    }

    @Test
    void groundReachesTheHorizonBelowRobotsThatHaveLeftThePitch() throws IOException {
        browser.drawSharply();
        open(CHEAP);
        browser.evaluate("studio.camera.jumpTo({target: [30, 0, 1.4], azimuthDegrees: 180, elevationDegrees: 2,"
                + " distance: 8}); studio.touch()");
        browser.await("studio.camera.isStill && !studio.session.stale");
        double horizon = browser.evaluate("((" + SEEN + ")(10000, 0, 0))[1]").getAsDouble();

        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(browser.screenshot()));
        Color sky = new Color(picture.getRGB(300, (int) horizon - 30));
        Color arena = new Color(picture.getRGB(300, (int) horizon + 30));

        assertThat(sky.getBlue() - arena.getBlue()).isGreaterThan(35);
        assertThat(arena.getGreen()).isGreaterThan(arena.getBlue());
    }

    @Test
    void robotCamerasAreNotChosenWithoutARobot() {
        open(CHEAP);
        browser.await("studio.camera.mode === 'orbit' && studio.camera.isStill && studio.view.covered.bottom > 0");
        browser.evaluate("studio.camera.zoom(0.8)");
        double distance = browser.evaluate("studio.camera.view.distance").getAsDouble();

        browser.press("2");

        browser.await("document.querySelector('[data-camera=orbit]').ariaPressed === 'true'");
        assertThat(browser.evaluate("studio.camera.view.distance").getAsDouble())
                .isEqualTo(distance);
    }

    @Test
    void ballIsNeverSmallerThanFourPixels() {
        open(CHEAP);

        browser.evaluate("studio.camera.jumpTo({...studio.camera.view, distance: 60}); studio.touch()");
        browser.await("studio.camera.isStill && !studio.session.stale");

        double pixels = browser.evaluate("(() => { const see = " + SEEN + "; const { x, y, z } ="
                        + " studio.view.ball.position; const r = 0.042 * studio.view.ball.scale.x;"
                        + " return see(x + r, y, z)[0] - see(x - r, y, z)[0]; })()")
                .getAsDouble();
        assertThat(pixels).isCloseTo(4, within(0.2));
    }

    @Test
    void wheelZoomsToThePointer() {
        openWithRobot(CHEAP);
        browser.press("1");
        browser.await("studio.camera.mode === 'orbit' && studio.camera.isStill");
        browser.evaluate("window.spot = (" + SEEN + ")(3, 1, 0)");

        browser.evaluate("studio.view.stage.dispatchEvent(new WheelEvent('wheel', {deltaY: -500, clientX: spot[0],"
                + " clientY: spot[1], cancelable: true}))");
        browser.await("studio.camera.isStill && studio.camera.shown.distance < 10");

        assertThat(browser.evaluate("Math.hypot(...(" + SEEN + ")(3, 1, 0).map((value, i) => value - spot[i]))")
                        .getAsDouble())
                .isLessThan(3);
    }
}
