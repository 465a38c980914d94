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

/**
 * Takes the screenshot of the README and checks its content.
 */
@Tag("slow")
@Tag("picture")
class StudioPictureTest {

    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final String VIEW = "studio.camera.jumpTo({target: [-3.3, 0.12, 0.27], azimuthDegrees: -29,"
            + " elevationDegrees: 9.5, distance: 1.68}); studio.touch()";

    @TempDir
    private Path folder;

    @Test
    void takesScreenshotOfTheField() throws IOException {
        Tool.BROWSER.orSkip();

        byte[] png = takePicture();

        Picture.ofDocumentation("docs/images/studio-field.png", png);
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(png));
        assertThat(picture.getWidth()).isEqualTo(WIDTH);
        assertThat(picture.getHeight()).isEqualTo(HEIGHT);
        assertThat(share(picture, StudioPictureTest::isGrass)).as("grass").isGreaterThan(0.2);
        assertThat(share(picture, StudioPictureTest::isTeamBlue)).as("blue").isGreaterThan(0.002);
        assertThat(share(picture, StudioPictureTest::isTeamOrange)).as("orange").isGreaterThan(0.0005);
        assertThat(share(picture, StudioPictureTest::isDark)).as("joints").isGreaterThan(0.004);
    }

    private byte[] takePicture() throws IOException {
        try (TestSimulator simulation = new TestSimulator()
                        .withRobot(RobotType.TYPE_0, TeamSide.LEFT, 1, -3.42, 0.1, -4, Posture.GREETING)
                        .withRobot(RobotType.TYPE_0, TeamSide.RIGHT, 7, -4.7, 1.45, -60, Posture.STANDING);
                Chromium browser = Chromium.open(WIDTH, HEIGHT)) {
            simulation.order(new Order.MoveBall(new Vector3(-3.0, -0.16, 0.042), Vector3.ZERO));
            simulation.afterCycles(150);
            simulation.order(new Order.Pause());
            try (WholeStudio studio = new WholeStudio(simulation.control(), folder)) {
                browser.visit(studio.oneTimeAddress() + "&quality=high&shadows=on&theme=light");
                browser.await("studio.state.scene.robots.length === 2 && studio.state.frame");
                browser.click("#first-steps button");
                browser.press("1");
                browser.evaluate(VIEW);
                browser.await("studio.camera.isStill");
                return browser.screenshot();
            }
        }
    }

    private static double share(BufferedImage picture, IntPredicate colour) {
        long found = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                found += colour.test(picture.getRGB(x, y)) ? 1 : 0;
            }
        }
        return (double) found / (WIDTH * HEIGHT);
    }

    private static boolean isGrass(int rgb) {
        return green(rgb) > red(rgb) + 40 && green(rgb) > blue(rgb) + 40;
    }

    private static boolean isTeamBlue(int rgb) {
        return blue(rgb) > red(rgb) + 110 && blue(rgb) > green(rgb) + 50;
    }

    private static boolean isTeamOrange(int rgb) {
        return red(rgb) > blue(rgb) + 120 && red(rgb) > green(rgb) + 50;
    }

    private static boolean isDark(int rgb) {
        return red(rgb) + green(rgb) + blue(rgb) < 180;
    }

    private static int red(int rgb) {
        return (rgb >> 16) & 0xff;
    }

    private static int green(int rgb) {
        return (rgb >> 8) & 0xff;
    }

    private static int blue(int rgb) {
        return rgb & 0xff;
    }
}
