package org.robonewbie.simulator.landscape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;

class LandscapeTest {

    @Test
    void eachLandscapeIsFoundByItsName() {
        for (Landscape landscape : Landscape.ALL) {
            assertThat(Landscape.named(landscape.name())).isSameAs(landscape);
        }
    }

    @Test
    void unknownNameIsRefusedWithTheNamesThatExist() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Landscape.named("moon"))
                .withMessage("There is no scene \"moon\". Choose one of soccer, obstacles, slope, box.");
    }

    @Test
    void slopeBeginsAtTheGroundAndEndsLevelWithTheTop() {
        List<Thing> hill = Landscape.SLOPE.things();
        Thing slope = hill.get(0);
        Thing top = hill.get(1);
        Vector3 half = slope.size().times(0.5);

        Vector3 lowerEdge = slope.pose().transform(new Vector3(-half.x(), 0, half.z()));
        Vector3 upperEdge = slope.pose().transform(new Vector3(half.x(), 0, half.z()));

        assertThat(lowerEdge.z()).isCloseTo(0, within(1e-9));
        assertThat(upperEdge.z()).isCloseTo(top.size().z(), within(1e-9));
        assertThat(upperEdge.x()).isCloseTo(top.centre().x() - top.size().x() / 2, within(1e-9));
    }

    @Test
    void nothingReachesIntoTheGroundButTheSlopeThatComesOutOfIt() {
        for (Landscape landscape : Landscape.ALL) {
            for (Thing thing : landscape.things()) {
                if (!thing.name().equals("slope")) {
                    assertThat(thing.centre().z())
                            .as(thing.name())
                            .isEqualTo(thing.size().z() / 2);
                }
            }
        }
    }
}
