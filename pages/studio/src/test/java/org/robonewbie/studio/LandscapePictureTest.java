package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.IntPredicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.landscape.Landscape;

/**
 * Takes a screenshot of each world without soccer and checks that its objects are visible.
 */
@Tag("slow")
@Tag("picture")
@InBrowser(width = 960, height = 540)
class LandscapePictureTest {

    @TempDir
    private Path folder;

    private final Chromium browser;

    LandscapePictureTest(Chromium browser) {
        this.browser = browser;
    }

    @Test
    void obstaclesAreOnThePitch() throws IOException {
        BufferedImage picture = take("docs/images/scene-obstacles.png", Landscape.OBSTACLES, 1.1, -3.0, 1.1);

        assertThat(share(picture, LandscapePictureTest::isCardboard)).isGreaterThan(0.02);
    }

    @Test
    void slopeAndStepsAreOnThePitch() throws IOException {
        BufferedImage picture = take("docs/images/scene-slope.png", Landscape.SLOPE, 0, -4.6, 0);

        assertThat(share(picture, LandscapePictureTest::isGrey)).isGreaterThan(0.05);
    }

    @Test
    void boxIsOnThePitch() throws IOException {
        BufferedImage picture = take("docs/images/scene-box.png", Landscape.BOX, 0.45, -3.6, -0.45);

        assertThat(share(picture, LandscapePictureTest::isCardboard)).isGreaterThan(0.02);
    }

    /** Places a robot at x and the first y, and a second one at the other y if it differs. */
    private BufferedImage take(String file, Landscape landscape, double y, double x, double otherY) throws IOException {
        browser.drawSharply();
        try (TestSimulator simulation =
                new TestSimulator(landscape).withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, x, y, 0, Posture.STANDING)) {
            if (y != otherY) {
                simulation.withRobot(RobotType.TYPE_0, TeamSide.LEFT, 2, x, otherY, 0, Posture.STANDING);
            }
            simulation.order(new Order.MoveBall(new Vector3(-0.8, 0, 0.042), Vector3.ZERO));
            simulation.afterCycles(100);
            simulation.order(new Order.Pause());
            try (WholeStudio studio = new WholeStudio(simulation.control(), folder)) {
                browser.visit(studio.oneTimeAddress() + "&quality=high&shadows=on&theme=light");
                browser.await("studio.view.things.group.children.length === "
                        + landscape.things().size() + " && studio.state.frame");
                browser.press("1");
                browser.evaluate(
                        "studio.camera.jumpTo({target: [-2.9, 0, 0.1], azimuthDegrees: -65, elevationDegrees: 24,"
                                + " distance: 4.6}); studio.touch()");
                browser.await("studio.camera.isStill");
                byte[] png = browser.screenshot();
                Picture.ofDocumentation(file, png);
                return ImageIO.read(new ByteArrayInputStream(png));
            }
        }
    }

    private static double share(BufferedImage picture, IntPredicate colour) {
        long found = 0;
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                found += colour.test(picture.getRGB(x, y)) ? 1 : 0;
            }
        }
        return (double) found / (picture.getWidth() * picture.getHeight());
    }

    private static boolean isCardboard(int rgb) {
        return red(rgb) > 90 && red(rgb) > blue(rgb) + 60 && red(rgb) > green(rgb) + 15;
    }

    private static boolean isGrey(int rgb) {
        return red(rgb) > 70
                && red(rgb) < 215
                && Math.abs(red(rgb) - green(rgb)) < 20
                && Math.abs(green(rgb) - blue(rgb)) < 25;
    }

    private static int red(int rgb) {
        return rgb >> 16 & 0xff;
    }

    private static int green(int rgb) {
        return rgb >> 8 & 0xff;
    }

    private static int blue(int rgb) {
        return rgb & 0xff;
    }
}
