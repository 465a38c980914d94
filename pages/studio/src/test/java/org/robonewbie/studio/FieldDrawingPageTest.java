package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.protocol.telemetry.Drawing;
import org.robonewbie.protocol.telemetry.TelemetryItem.Picture;
import org.robonewbie.protocol.telemetry.TelemetryMessage;

/** Drawings of robots appear on the ground of the field, and their layers can be switched. */
@Tag("slow")
@InBrowser(width = 1440, height = 900)
class FieldDrawingPageTest {

    private static final String DRAWN = "studio.view.drawings";
    private static final String CORNERS = DRAWN + ".shapes.geometry.getAttribute('position').count";
    private static final int CIRCLE_CORNERS = 48 * 6;
    private static final int LINE_CORNERS = 6;

    private final Chromium browser;
    private final TestSimulator simulation = new TestSimulator()
            .withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -2, -1, 90, Posture.STANDING)
            .withRobot(RobotType.TYPE_4, TeamSide.RIGHT, 2, 2, -1, 180, Posture.STANDING);
    private StudioServer studio;

    FieldDrawingPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = StudioServer.start(simulation.control(), 0, AccessToken.random());
        visit();
        browser.evaluate("localStorage.removeItem('robonewbie-drawings-off')");
        visit();
        simulation.order(new Order.Pause());
        browser.await("studio.state.frame.paused");
    }

    private void visit() {
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest");
        browser.await("studio.state.scene?.robots.length === 2 && studio.view.robots.poses[1]?.[2] > 0");
    }

    @AfterEach
    void close() {
        studio.close();
        simulation.close();
    }

    private void draw(String team, int number, Drawing... drawings) {
        double now = simulation.latest().cycle() / 50.0;
        studio.telemetry().accept(new TelemetryMessage(team, number, now, new Picture(List.of(drawings))));
    }

    /** Both robots draw; repeated until the picture has arrived. */
    private void drawBoth() {
        simulation.awaitTrue(() -> {
            draw(
                    "Blue_Newbies",
                    1,
                    new Drawing.Circle(new Vector3(2, 0, -0.5), 0.5, "cyan"),
                    new Drawing.Text(new Vector3(2, 0, -0.5), "ball", "yellow"));
            draw("Orange_Rockets", 2, new Drawing.Line(new Vector3(1, 0, 0), new Vector3(1, 1, 0), "#f0f"));
            return browser.evaluate(CORNERS + " === " + (CIRCLE_CORNERS + LINE_CORNERS))
                    .getAsBoolean();
        });
    }

    @Test
    void drawingsLieOnTheGroundWhereTheRobotMeansThem() throws IOException {
        browser.drawSharply();
        visit();
        drawBoth();
        browser.press("3");
        browser.await("studio.camera.isStill && studio.camera.mode !== 'follow' && !studio.session.stale");

        JsonArray circle = browser.evaluate("(() => { const { view } = studio; const head ="
                        + " studio.state.scene.models.TYPE_0.links.findIndex(({name}) => name === 'head');"
                        + " const [x, y] = view.robots.poses[0].slice(7 * head); const point = new"
                        + " view.camera.position.constructor(x + 0.5, y + 2, 0.012).project(view.camera);"
                        + " const box = view.stage.getBoundingClientRect(); return [x, y, box.left"
                        + " + (point.x + 1) / 2 * box.width, box.top + (1 - point.y) / 2 * box.height]; })()")
                .getAsJsonArray();
        assertThat(circle.get(0).getAsDouble()).isBetween(-2.1, -1.9);
        assertThat(circle.get(1).getAsDouble()).isBetween(-1.1, -0.9);
        int x = circle.get(2).getAsInt();
        int y = circle.get(3).getAsInt();
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(browser.screenshot()));
        assertThat(isAnyCyan(picture, x, y)).isTrue();
        assertThat(isAnyCyan(picture, x + 40, y + 40)).isFalse();
        assertThat(browser.evaluate(DRAWN + ".texts.children.map(({ name }) => name).join()")
                        .getAsString())
                .isEqualTo("ball");
        assertThat(browser.complaints()).isEmpty();
    }

    private static boolean isAnyCyan(BufferedImage picture, int x, int y) {
        for (int dx = -4; dx <= 4; dx++) {
            for (int dy = -4; dy <= 4; dy++) {
                Color colour = new Color(picture.getRGB(x + dx, y + dy));
                if (Math.min(colour.getGreen(), colour.getBlue()) > colour.getRed() + 90) {
                    return true;
                }
            }
        }
        return false;
    }

    @Test
    void layersAreSwitchedAndRemembered() {
        assertThat(browser.evaluate("document.querySelector('#drawings').hidden")
                        .getAsBoolean())
                .as("before any robot draws")
                .isTrue();
        drawBoth();
        browser.click("#drawings summary");
        browser.await("document.querySelector('.layer-tree').innerText.includes('Orange_Rockets 2')");

        browser.click("[data-layer='Blue_Newbies\t1\tcircle']");
        browser.await(CORNERS + " === " + LINE_CORNERS + " && " + DRAWN + ".texts.children.length === 1");
        browser.click("[data-layer='Blue_Newbies\t1']");
        browser.await(DRAWN + ".texts.children.length === 0");
        visit();
        simulation.awaitTrue(() -> {
            draw("Orange_Rockets", 2, new Drawing.Point(Vector3.ZERO, "no colour"));
            draw("Blue_Newbies", 1, new Drawing.Point(Vector3.ZERO, "red"));
            return browser.evaluate("document.querySelectorAll('.layer-tree > .check').length === 2" + " && " + CORNERS
                            + " === 16 * 6")
                    .getAsBoolean();
        });

        browser.press("d");

        browser.await("!" + DRAWN + ".group.visible && !document.querySelector(\"[data-layer='']\").checked");
    }

    @Test
    void drawingsVanishWhenTheRobotDrawsNoMore() {
        drawBoth();

        simulation.order(new Order.Resume());

        browser.await("!" + DRAWN + ".group.visible");
    }
}
