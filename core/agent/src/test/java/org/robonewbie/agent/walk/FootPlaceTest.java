package org.robonewbie.agent.walk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;

class FootPlaceTest {

    @Test
    void turnsAboutTheStart() {
        FootPlace turned = FootPlace.LEFT.turned(90);

        assertThat(turned.forward()).isCloseTo(-FootPlace.HALF_WIDTH, within(1e-9));
        assertThat(turned.left()).isCloseTo(0, within(1e-9));
        assertThat(turned.yawDegrees()).isEqualTo(90);
    }

    @Test
    void isSeenStraightAheadFromAPlaceThatLooksAtIt() {
        FootPlace place = new FootPlace(0, 2, 0);

        Vector3 seen = place.seenFrom(new FootPlace(0, 1, 90));

        assertThat(seen.x()).isCloseTo(1, within(1e-9));
        assertThat(seen.y()).isCloseTo(0, within(1e-9));
    }
}
