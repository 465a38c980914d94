package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.order.PlayerNumber;

/** The first picture shows a single robot from its front right, large and not hidden by a goal. */
@Tag("slow")
@InBrowser
class FirstPicturePageTest {

    private static final double STANDING_HEIGHT = 0.366;

    /** Upper and lower end of the robot as fractions of the height above the transport bar. */
    private static final String ENDS = """
            (() => {
              const { view, state } = studio;
              const stage = view.stage.getBoundingClientRect();
              const { top } = stage;
              const bottom = document.querySelector('#transport').getBoundingClientRect().top;
              const [poses] = view.robots.poses;
              const head = state.scene.models[state.scene.robots[0].type].links.findIndex(({name}) => name === 'head');
              const seen = (z) => {
                const at = new view.camera.position.constructor(poses[0], poses[1], z).project(view.camera);
                return (stage.top + (1 - at.y) / 2 * stage.height - top) / (bottom - top);
              };
              return [seen(poses[7 * head + 2] + 0.065), seen(0)];
            })()""";

    /** Direction of the camera from the robot, counter-clockwise from its heading. */
    private static final String BEARING = """
            ((headingDegrees) => {
              const [x, y] = studio.view.robots.poses[0];
              const { x: right, y: up } = studio.view.camera.position;
              const degrees = Math.atan2(up - y, right - x) * 180 / Math.PI - headingDegrees;
              return ((degrees + 180) % 360 + 360) % 360 - 180;
            })""";

    /** Number of visible posts, bars and threads in front of the robot's limbs. */
    private static final String IN_FRONT = """
            import('three').then(({ Raycaster, Vector3 }) => {
              const { camera, goals, robots } = studio.view;
              const [poses] = robots.poses;
              const caster = new Raycaster();
              caster.params.Line.threshold = 0.01;
              let count = 0;
              for (let at = 0; at < poses.length; at += 7) {
                const way = new Vector3(...poses.subarray(at, at + 3)).sub(camera.position);
                caster.far = way.length();
                caster.set(camera.position, way.normalize());
                count += caster.intersectObject(goals.group)
                  .filter(({object, point}) => object.material.opacity > 0.1 && point.z > 0.01) // without flat shadows
                  .length;
              }
              return count;
            })""";

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator();
    private StudioServer studio;

    FirstPicturePageTest(Chromium browser) {
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

    private void openWithRobot(double x, double y, double headingDegrees) {
        simulation.withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, x, y, headingDegrees, Posture.STANDING);
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest");
        browser.await("window.studio?.camera?.viewOfRobot && studio.view.covered.bottom > 0 && studio.camera.isStill"
                + " && studio.view.goals.goals.every(({opacity}) => opacity === 1 || opacity < 0.1)");
    }

    private double number(String expression) {
        return browser.evaluate(expression).getAsDouble();
    }

    @ParameterizedTest
    @CsvSource({
        "at its own goal, 1366, 768, -4.9, 0, 0",
        "at its own goal, 1024, 768, -4.9, 0, 0",
        "before its own goal, 1366, 768, -4.8, 0.3, 180",
        "at the other goal, 1366, 768, 4.9, 0.5, -20",
        "beside a post, 1366, 768, -5.8, -1.4, 60",
    })
    void singleRobotIsSeenLargeFromItsFrontRight(
            String where, int width, int height, double x, double y, double headingDegrees) {
        browser.resize(width, height);

        openWithRobot(x, y, headingDegrees);

        double top = number(ENDS + "[0]");
        double bottom = number(ENDS + "[1]");
        assertThat(top).as("top of the robot " + where).isPositive();
        assertThat(bottom).as("soles of the robot " + where).isLessThan(1);
        assertThat(bottom - top).as("height of the robot " + where).isBetween(0.35, 0.65);
        assertThat(number(BEARING + "(" + headingDegrees + ")"))
                .as("camera " + where)
                .isBetween(-60.0, -10.0);
        assertThat(number(IN_FRONT)).as("bars in front of the robot " + where).isZero();
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void noOtherGroundLiesBelowTheGrass() {
        openWithRobot(-4.9, 0, 0);

        double grounds = number("""
                import('three').then(({ Raycaster, Vector3 }) =>
                  new Raycaster(new Vector3(1.3, 2, 1), new Vector3(0, 0, -1))
                    .intersectObject(studio.view.pitch)
                    .filter(({ object }) => object.geometry.attributes.color).length)""");

        assertThat(grounds).isEqualTo(1);
    }

    @Test
    void goalFadesOutWhileTheUserTurnsTheViewBehindIt() {
        openWithRobot(-4.9, 0, 0);
        browser.await("studio.view.goals.goals[0].opacity === 1");

        browser.evaluate("studio.field.looks.turn(-145, 0)");

        browser.await("studio.view.goals.goals[0].opacity < 0.1 && studio.camera.isStill");
        assertThat(number(IN_FRONT)).isZero();
        assertThat(number("studio.view.goals.goals[1].opacity")).isEqualTo(1);
        browser.evaluate("studio.field.looks.turn(145, 0)");
        browser.await("studio.view.goals.goals[0].opacity === 1");
    }

    @Test
    void overviewHidesNoGoal() {
        openWithRobot(-4.8, 0, -130);
        browser.await("studio.view.goals.goals[0].opacity < 0.1");

        browser.press("1");

        browser.await("studio.view.goals.goals[0].opacity === 1");
    }

    @Test
    void robotIsSeenFromItsFrontAgainAfterABeam() {
        openWithRobot(-4.9, 0, 0);

        simulation.order(
                new Order.PlaceRobot(new PlayerNumber(TeamSide.LEFT, 1), new Vector3(2, 1, STANDING_HEIGHT), -90));

        browser.await("studio.camera.shown.target[0] > 1.9 && studio.camera.isStill");
        assertThat(number(BEARING + "(-90)")).isBetween(-60.0, -10.0);
        assertThat(number(ENDS + "[1]") - number(ENDS + "[0]")).isBetween(0.35, 0.65);
    }
}
