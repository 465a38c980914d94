package org.robonewbie.learning.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class BallPlaceTest {

    private static final BallPlace PLACE = new BallPlace(0.19, -0.055);

    @Test
    void readsWhatItHasWritten() {
        assertThat(BallPlace.of(PLACE.toString())).isEqualTo(PLACE);
    }

    @Test
    void liesBeforeTheOtherFootInItsMirrorImage() {
        assertThat(PLACE.mirrored()).isEqualTo(new BallPlace(0.19, 0.055));
    }

    @Test
    void isAtMostACentimetreBesideItsPlaceInATrial() {
        Random random = new Random(5);

        for (int i = 0; i < 100; i++) {
            BallPlace near = PLACE.near(random);
            assertThat(near.ahead()).isCloseTo(PLACE.ahead(), within(0.01));
            assertThat(near.left()).isCloseTo(PLACE.left(), within(0.01));
        }
        assertThat(PLACE.near(random)).isNotEqualTo(PLACE.near(random));
    }
}
