package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.SimulationControl;

/** The studio in a real browser with software rendering. */
@InBrowser(width = 640, height = 360)
class StudioPageTest {

    private static final AccessToken TOKEN = AccessToken.random();
    private static final String CHEAP = "&quality=lowest";

    /** Number of pictures drawn so far. */
    private static final String PICTURES = "studio.view.renderer.info.render.frame";

    private final Chromium browser;

    private TestSimulator simulation = new TestSimulator();
    private StudioServer studio = serve(0);

    StudioPageTest(Chromium browser) {
        this.browser = browser;
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private StudioServer serve(int port) {
        try {
            return StudioServer.start(simulation.control(), port, TOKEN);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void openStudio() {
        browser.visit(studio.oneTimeAddress() + CHEAP);
        browser.await("studio.state.frame && studio.view.drawCalls > 0");
    }

    private void openStudioWithRobot() {
        simulation.withRobot();
        openStudio();
        browser.await("studio.camera.scene?.robots.length === 1 && studio.state.frame"
                + " && !document.querySelector('#toggle').disabled");
    }

    @Test
    void robotAppearsWithoutConsoleErrors() {
        openStudioWithRobot();
        browser.await("studio.view.robots.meshes.some(mesh => mesh.visible)");

        browser.await("document.querySelector('#banner').hidden");
        browser.await("document.querySelector('.team.left').textContent === 'Blue_Newbies'");
        browser.await("studio.camera.mode === 'follow'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void emptyFieldWaitsForARobot() {
        openStudio();

        browser.await("document.querySelector('#banner strong').textContent.startsWith('Waiting for a robot')");
        assertThat(browser.evaluate("document.querySelector('#banner').hidden").getAsBoolean())
                .isFalse();
    }

    @Tag("slow")
    @Test
    void keysFollowTheNextRobot() {
        simulation.withRobot().withRobot(RobotType.TYPE_0, TeamSide.RIGHT, 5, 1, 0, 180, Posture.STANDING);
        openStudio();
        browser.await("studio.camera.scene?.robots.length === 2");

        browser.press("n");

        browser.await("studio.camera.mode === 'follow' && studio.camera.chosen === 1");
    }

    @Tag("slow")
    @Test
    void buttonsPauseStepAndPlay() {
        openStudioWithRobot();

        browser.click("#toggle");
        await(() -> simulation.latest().paused());
        browser.await("document.querySelector('#toggle').textContent.includes('Play')");
        long cycle = simulation.latest().cycle();
        browser.click("#step");
        await(() -> simulation.latest().cycle() == cycle + 1);
        browser.click("#toggle");
        await(() -> simulation.latest().cycle() > cycle + 5);

        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void keysPauseStepAndChangeSpeed() {
        openStudioWithRobot();

        browser.press(" ");
        await(() -> simulation.latest().paused());
        long cycle = simulation.latest().cycle();
        browser.press(",");
        await(() -> simulation.latest().cycle() == cycle + 10);
        browser.await("studio.state.frame.speed === 1");
        browser.press("+");
        await(() -> simulation.latest().speed() == 2);
        browser.await("studio.state.frame.speed === 2");
        browser.press("-");
        await(() -> simulation.latest().speed() == 1);
    }

    @Tag("slow")
    @Test
    void speedIsChosenFromTheList() {
        openStudioWithRobot();

        browser.fill("#speed", "fastest");

        await(() -> simulation.latest().speed() == SimulationControl.AS_FAST_AS_POSSIBLE);
    }

    @Tag("slow")
    @Test
    void resetBringsTheBallBack() {
        openStudioWithRobot();
        simulation.order(new Order.MoveBall(new Vector3(2, 1, 0.042), Vector3.ZERO));
        await(() -> simulation.latest().ballPosition().x() > 1.9);

        browser.click("#reset");

        await(() -> simulation.latest().ballPosition().length() < 0.1);
    }

    @Tag("slow")
    @Test
    void refereeIsControlledByButtonAndList() {
        openStudioWithRobot();

        browser.fill("#play-mode", "goal_kick_left");
        await(() -> simulation.latest().playMode() == PlayMode.GOAL_KICK_LEFT);
        browser.click("#drop-ball");

        await(() -> simulation.latest().playMode() == PlayMode.PLAY_ON);
        browser.await("document.querySelector('.mode').textContent === 'Play on'");
    }

    @Test
    void ballIsDraggedWithTheMouse() {
        openStudioWithRobot();
        browser.press("3");
        browser.await("studio.camera.mode === 'top' && studio.camera.isStill");

        drag(onScreen("studio.view.ball.position"), 0, 60);

        await(() -> simulation.latest().ballPosition().y() < -0.8);
        assertThat(simulation.latest().ballPosition().x()).isCloseTo(0, within(0.3));
    }

    @Tag("slow")
    @Test
    void robotIsDraggedWithTheMouseAndRemainsUpright() {
        openStudioWithRobot();
        browser.press("3");
        browser.await("studio.camera.mode === 'top' && studio.camera.isStill");

        drag(onScreen("new studio.view.camera.position.constructor(...studio.view.robots.poses[0])"), 60, 0);

        await(() -> simulation.latest().robots().get(0).body().position().x() > 0.3);
        assertThat(simulation.latest().robots().get(0).body().position().z()).isBetween(0.3, 0.45);
    }

    private double[] onScreen(String vector) {
        browser.evaluate("window.spot = " + vector + ".clone().project(studio.view.camera)");
        browser.evaluate("window.box = studio.view.stage.getBoundingClientRect()");
        return new double[] {
            browser.evaluate("box.left + (spot.x + 1) / 2 * box.width").getAsDouble(),
            browser.evaluate("box.top + (1 - spot.y) / 2 * box.height").getAsDouble()
        };
    }

    private void drag(double[] from, double right, double down) {
        browser.mouse("mousePressed", from[0], from[1]);
        for (int i = 1; i <= 4; i++) {
            browser.mouse("mouseMoved", from[0] + right * i / 4, from[1] + down * i / 4);
        }
        browser.mouse("mouseReleased", from[0] + right, from[1] + down);
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"1, orbit", "2, follow", "3, top", "4, eye"})
    void keysChooseTheCamera(String key, String mode) {
        openStudioWithRobot();

        browser.press(key);

        browser.await("studio.camera.mode === '" + mode + "'");
        browser.await("document.querySelector('[data-camera=" + mode + "]').ariaPressed === 'true'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void arrowKeysTurnTheView() {
        openStudioWithRobot();
        double before = browser.evaluate("studio.camera.view.azimuthDegrees").getAsDouble();

        browser.press("ArrowRight");

        browser.await("studio.camera.view.azimuthDegrees > " + (before + 3));
    }

    @Tag("slow")
    @Test
    void realShadowsCanBeSwitchedOn() {
        openStudioWithRobot();

        browser.click("#shadows");

        browser.await("studio.view.renderer.shadowMap.enabled && !studio.view.softShadows.group.visible");
        assertThat(browser.complaints()).isEmpty();
    }

    @Tag("slow")
    @Test
    void themeIsSwitched() {
        openStudioWithRobot();
        String before =
                browser.evaluate("document.documentElement.dataset.theme").getAsString();

        browser.click("#theme-button");

        browser.await("document.documentElement.dataset.theme !== " + Chromium.quoted(before));
        browser.click("#theme-button");
    }

    @Tag("slow")
    @Test
    void pageReconnectsWhenTheSimulatorIsRestarted() {
        openStudioWithRobot();
        int port = studio.address().getPort();

        studio.close();
        browser.await("document.querySelector('#banner').innerText.includes('The simulator has ended')");
        simulation.close();
        simulation = new TestSimulator().withRobot(RobotType.TYPE_1, TeamSide.LEFT, 9, 1, 1, 180, Posture.STANDING);
        serveAgain(port);

        browser.await("studio.state.scene.robots[0].number === 9 && studio.state.frame");
        browser.await("document.querySelector('#banner').hidden");
    }

    /** Starts again; the page that tries to reconnect may hold the port for a moment. */
    private void serveAgain(int port) {
        await(() -> {
            try {
                studio = StudioServer.start(simulation.control(), port, TOKEN);
                return true;
            } catch (IOException stillTaken) {
                return false;
            }
        });
    }

    @Tag("slow")
    @Test
    void twentyTwoRobotsOfAllTypesNeedAtMostAHundredDrawCalls() {
        for (int i = 0; i < 22; i++) {
            simulation.withRobot(
                    RobotType.values()[i % 5],
                    i < 11 ? TeamSide.LEFT : TeamSide.RIGHT,
                    i % 11 + 1,
                    -5 + 0.9 * (i % 11),
                    i < 11 ? -1.5 : 1.5,
                    90,
                    Posture.STANDING);
        }
        openStudio();
        browser.await("studio.state.scene.robots.length === 22 && studio.view.robots.poses[21]?.[2] > 0");
        int calls = browser.evaluate("studio.view.drawCalls").getAsInt();
        browser.click("#shadows");
        browser.await("studio.view.renderer.shadowMap.enabled");
        int pictures = browser.evaluate(PICTURES).getAsInt();
        browser.await(PICTURES + " > " + pictures);

        assertThat(calls).isBetween(6, 20);
        assertThat(browser.evaluate("studio.view.drawCalls").getAsInt()).isLessThanOrEqualTo(100);
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"1366x768", "1024x768", "1920x1080"})
    void layoutFitsCommonScreens(String size) {
        openStudioWithRobot();
        String[] sides = size.split("x", 2);
        browser.resize(Integer.parseInt(sides[0]), Integer.parseInt(sides[1]));
        try {
            browser.await("innerWidth === " + sides[0]);

            browser.await("(" + PANELS_THAT_DO_NOT_FIT + ") === ''");
            assertThat(browser.evaluate(SMALLEST_TEXT).getAsDouble()).isGreaterThanOrEqualTo(12);
        } finally {
            browser.resize(640, 360);
        }
    }

    @Tag("slow")
    @Test
    void phoneShowsAllControlsOfFieldAndReplay() {
        openStudioWithRobot();
        browser.resize(390, 844);
        try {
            browser.await("innerWidth === 390");
            browser.await(CONTROLS_BEYOND_THE_EDGE + " === ''");
            browser.evaluate("location.hash = '#replay'");
            browser.await("studio.replay && " + CONTROLS_BEYOND_THE_EDGE + " === ''");
            browser.evaluate("location.hash = '#motion'");
            browser.await("getComputedStyle(document.querySelector('#motion-room'), '::after').content"
                    + ".includes('needs a wider window')");
        } finally {
            browser.resize(640, 360);
        }
    }

    private static final String CONTROLS_BEYOND_THE_EDGE = """
            [...document.querySelectorAll('button, select, input')]
              .filter((control) => control.checkVisibility() && !control.closest('#rooms'))
              .filter((control) => { const box = control.getBoundingClientRect(); return box.left < 0 || box.right > innerWidth; })
              .map((control) => control.id || control.textContent).join()""";

    private static final String PANELS_THAT_DO_NOT_FIT = """
            (() => {
              const panels = [...document.querySelectorAll('.panel, .bar')].filter((panel) => panel.offsetParent);
              const seen = (panel) => {
                const box = panel.getBoundingClientRect();
                const frame = panel.closest('#side')?.getBoundingClientRect() ?? box;
                return { left: box.left, right: box.right, top: box.top, bottom: Math.min(box.bottom, frame.bottom) };
              };
              const boxes = panels.map((panel) => [panel.id, seen(panel)]).filter(([, box]) => box.bottom > box.top);
              const bad = [];
              for (const [id, box] of boxes) {
                if (box.left < 0 || box.top < 0 || box.right > innerWidth || box.bottom > innerHeight) bad.push(id);
                for (const [other, rest] of boxes) {
                  const apart = box.right <= rest.left || rest.right <= box.left || box.bottom <= rest.top
                    || rest.bottom <= box.top;
                  if (id < other && !apart) bad.push(id + ' over ' + other);
                }
              }
              return bad.join(', ');
            })()""";

    private static final String SMALLEST_TEXT = """
            Math.min(...[...document.querySelectorAll('body *')]
              .filter((one) => one.textContent.trim()).map((one) => parseFloat(getComputedStyle(one).fontSize)))""";

    private void await(BooleanSupplier condition) {
        simulation.awaitTrue(condition);
    }
}
