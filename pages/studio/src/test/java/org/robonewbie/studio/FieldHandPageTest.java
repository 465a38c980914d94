package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonArray;
import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/** Names and trail in the 3D view, and mouse operations on robots and ball. */
@Tag("slow")
@InBrowser(width = 1440, height = 900)
class FieldHandPageTest {

    private static final String ON_PAGE = "((x, y, z) => { const box = studio.view.stage.getBoundingClientRect();"
            + " const at = new studio.view.camera.position.constructor(x, y, z).project(studio.view.camera);"
            + " return [box.left + (at.x + 1) / 2 * box.width, box.top + (1 - at.y) / 2 * box.height]; })";
    private static final int CONTROL = 2;

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private StudioServer studio;

    FieldHandPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void openFieldWithRobots() throws IOException {
        simulation
                .withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -1, 0.5, 0, Posture.STANDING)
                .withRobot(RobotType.TYPE_0, TeamSide.RIGHT, 7, 2, 1, 180, Posture.STANDING);
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest");
        browser.await("studio.state.scene?.robots.length === 2 && studio.view.robots.poses[1]?.[2] > 0"
                + " && studio.view.covered.bottom > 0");
        browser.await("studio.camera.isStill && !document.querySelector('#scenes').hidden");
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private double[] onPage(double x, double y, double z) {
        JsonArray place =
                browser.evaluate(ON_PAGE + "(" + x + ", " + y + ", " + z + ")").getAsJsonArray();
        return new double[] {place.get(0).getAsDouble(), place.get(1).getAsDouble()};
    }

    private void drag(double[] from, double[] to, int keys, String over) {
        browser.mouse("mouseMoved", from[0], from[1], keys);
        browser.await("document.querySelector('#stage').dataset.over === '" + over + "'");
        browser.mouse("mousePressed", from[0], from[1], keys);
        browser.mouse("mouseMoved", to[0], to[1], keys);
        browser.mouse("mouseReleased", to[0], to[1], keys);
    }

    private double heading(int robot) {
        return simulation.latest().robots().get(robot).body().headingDegrees();
    }

    @Test
    void namesStandAboveTheRobotsUntilTheyAreSwitchedOff() {
        browser.await("[...document.querySelectorAll('.name-tag')].map(tag => tag.textContent).join()"
                + " === 'Blue_Newbies 1,Orange_Rockets 7'");
        browser.await(
                "[...document.querySelectorAll('.name-tag')].every(tag => tag.checkVisibility({visibilityProperty:"
                        + " true}))");
        double[] head = onPage(-1, 0.5, 0.6);
        assertThat(browser.evaluate("(() => { const box = document.querySelector('.name-tag').getBoundingClientRect();"
                                + " return box.left + box.width / 2; })()")
                        .getAsDouble())
                .isCloseTo(head[0], within(8.0));

        browser.click("#names");
        browser.await("!document.querySelector('.name-tag').checkVisibility()");
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest");

        browser.await("document.querySelector('#names') && !document.querySelector('#names').checked");
    }

    @Test
    void robotIsTurnedByItsRing() {
        double[] robot = onPage(-1, 0.5, 0.35);
        browser.mouse("mouseMoved", robot[0], robot[1]);
        browser.await("studio.view.ring.group.visible && !document.querySelector('#stage-tip').hidden");

        drag(onPage(-1 + ringOf("robot"), 0.5, 0), onPage(-1, 2.5, 0), 0, "robot-ring");

        simulation.awaitTrue(() -> Math.abs(heading(0) - 90) < 8);
        assertThat(simulation.latest().robots().get(0).body().position().x()).isCloseTo(-1, within(0.1));
    }

    private double ringOf(String kind) {
        String thing = kind.equals("ball") ? "{kind: 'ball'}" : "{kind: 'robot', robot: 0}";
        return browser.evaluate("studio.pointer.pointing.radiusOf(" + thing + ")")
                .getAsDouble();
    }

    @Test
    void ballIsThrownByItsRingAndLeavesATrail() {
        browser.mouse("mouseMoved", onPage(0, 0, 0.04)[0], onPage(0, 0, 0.04)[1]);
        browser.await("document.querySelector('#stage').dataset.over === 'ball'");

        drag(onPage(0, -ringOf("ball"), 0), onPage(0, -1.5, 0), 0, "ball-ring");

        simulation.awaitTrue(() -> simulation.latest().ballPosition().y() < -1);
        browser.await("studio.view.trail.dots.visible && studio.view.trail.dots.geometry.drawRange.count > 5");
        browser.click("#trail");
        browser.await("!studio.view.trail.dots.visible");
    }

    @Test
    void controlThrowsTheBallWithoutAimingAtTheRing() {
        drag(onPage(0, 0, 0.04), onPage(-2, 0, 0), CONTROL, "ball");

        simulation.awaitTrue(() -> simulation.latest().ballPosition().x() < -0.6);
    }

    @Test
    void cameraFollowsTheBallAndAGoalIsShownAgain() {
        browser.press("5");
        browser.evaluate("studio.send({do: 'placeBall', x: 3, y: -2, z: 0.042})");
        browser.await("studio.camera.mode === 'ball' && Math.abs(studio.camera.shown.target[0] - 3) < 0.1"
                + " && Math.abs(studio.camera.shown.target[1] + 2) < 0.1");
        browser.click("#goal-replays");
        browser.await("document.querySelector('#goal-replays').checked");

        browser.evaluate("studio.session.state = {...studio.session.state, goal: {side: 'left', milliseconds: 1}}");

        browser.await("!document.querySelector('#goal-again').hidden && studio.session.shown.tense === 'past'");
        browser.await("document.querySelector('#goal-again').hidden && studio.session.shown.tense === 'live'");
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void keyboardHelpExplainsTheRings() {
        browser.press("?");

        browser.await("document.querySelector('#help').open && /Pull the ball’s ring.*throw the ball/s"
                + ".test(document.querySelector('#help').textContent)");
        assertThat(browser.complaints()).isEmpty();
    }
}
