package org.robonewbie.nao.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class BallPlaceTest {

    private static final BallPlace PLACE = new BallPlace(0.19, -0.055);

    @Test
    void readsWhatItHasWritten() {
        assertThat(BallPlace.parse(PLACE.toString())).contains(PLACE);
    }

    @Test
    void isReadFromTheCommentOfAMotionFile() {
        MotionFile kick = MotionFile.parse("kick.txt", "// ball: 0.190 m ahead, -0.055 m to the left");
        MotionFile wave = MotionFile.parse("wave.txt", "// ball: none");

        assertThat(kick.ball()).contains(PLACE);
        assertThat(wave.ball()).isEmpty();
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
