package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.robonewbie.simulator.physics.Material;

/** The pairs of surfaces as they act in rcssserver3d 0.7.3. */
class SurfaceMaterialsTest {

    private static final Offset<Double> EXACT = within(1e-12);

    @Test
    void footOnTheGround() {
        Material pair = SurfaceMaterials.ROBOT.mixedWith(SurfaceMaterials.GROUND);

        assertThat(pair.bounce()).isEmpty();
        assertContact(pair, 0.4, 1e-4, 0.005);
    }

    @Test
    void ballOnTheGround() {
        Material pair = SurfaceMaterials.BALL.mixedWith(SurfaceMaterials.GROUND);

        assertBounce(pair, 0.8, 0.8);
        assertContact(pair, 0.35, 0.05, 0.3025);
    }

    @Test
    void ballAgainstRobot() {
        Material pair = SurfaceMaterials.BALL.mixedWith(SurfaceMaterials.ROBOT);

        assertBounce(pair, 0.8, 0.8);
        assertContact(pair, 0.55, 0.02505, 0.3025);
    }

    @Test
    void ballAgainstWall() {
        Material pair = SurfaceMaterials.BALL.mixedWith(SurfaceMaterials.WALL);

        assertBounce(pair, 0.8, 1.4);
        assertContact(pair, 0.5, 0.05, 0.6);
    }

    @Test
    void robotAgainstWall() {
        Material pair = SurfaceMaterials.ROBOT.mixedWith(SurfaceMaterials.WALL);

        assertBounce(pair, 0.8, 2.0);
        assertContact(pair, 0.6, 1e-4, 0.005);
    }

    @Test
    void robotAgainstRobot() {
        Material pair = SurfaceMaterials.ROBOT.mixedWith(SurfaceMaterials.ROBOT);

        assertThat(pair.bounce()).isEmpty();
        assertContact(pair, 0.6, 1e-4, 0.005);
    }

    private static void assertBounce(Material pair, double restitution, double minimumVelocity) {
        assertThat(pair.bounce().orElseThrow().restitution()).isCloseTo(restitution, EXACT);
        assertThat(pair.bounce().orElseThrow().minimumVelocity()).isCloseTo(minimumVelocity, EXACT);
    }

    private static void assertContact(Material pair, double errorReduction, double softness, double slip) {
        assertThat(pair.errorReduction().orElseThrow()).isCloseTo(errorReduction, EXACT);
        assertThat(pair.softness().orElseThrow()).isCloseTo(softness, EXACT);
        assertThat(pair.slip().orElseThrow()).isCloseTo(slip, EXACT);
    }
}
