package org.robonewbie.team.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.geometry.Translation2d;

class BallFilterTest {

    private static final double PICTURE_SECONDS = 0.06;

    private final BallFilter filter = new BallFilter();
    private final Random noise = new Random(1);

    @Test
    void knowsNothingAtFirst() {
        assertThat(filter.isKnown()).isFalse();
        assertThat(filter.deviation()).isInfinite();
    }

    @Test
    void believesTheFirstPicture() {
        filter.see(new Translation2d(2, 1), 0.03);

        assertThat(filter.position()).isEqualTo(new Translation2d(2, 1));
        assertThat(filter.velocity()).isEqualTo(Translation2d.ORIGIN);
    }

    @Test
    void findsOutHowFastTheBallRolls() {
        watch(new Translation2d(0, 0), new Translation2d(2, -1), 10);

        double slower = Math.exp(-9 * PICTURE_SECONDS / BallFilter.ROLLING_SECONDS);
        assertThat(filter.velocity().x()).isCloseTo(2 * slower, within(0.2));
        assertThat(filter.velocity().y()).isCloseTo(-slower, within(0.2));
    }

    @Test
    void foreseesWhereTheBallComesToRest() {
        watch(new Translation2d(1, 2), new Translation2d(2, 0), 12);

        Translation2d rest = BallFilter.predict(filter.position(), filter.velocity(), 10);
        assertThat(rest.distanceTo(new Translation2d(1 + 2 * BallFilter.ROLLING_SECONDS, 2)))
                .isLessThan(0.15);
    }

    @Test
    void seesALyingBallMoreExactlyThanAnyPictureShowsIt() {
        watch(new Translation2d(3, 3), Translation2d.ORIGIN, 60);

        assertThat(filter.position().distanceTo(new Translation2d(3, 3))).isLessThan(0.02);
        assertThat(filter.velocity().length()).isLessThan(0.1);
        assertThat(filter.deviation()).isLessThan(0.03);
    }

    @Test
    void noticesAKickAtOnce() {
        watch(Translation2d.ORIGIN, Translation2d.ORIGIN, 30);

        watch(new Translation2d(0.2, 0), new Translation2d(4, 0), 4);

        assertThat(filter.velocity().x()).isGreaterThan(2.5);
    }

    @Test
    void becomesUncertainWhileItSeesNothing() {
        watch(Translation2d.ORIGIN, Translation2d.ORIGIN, 30);
        double before = filter.deviation();

        filter.roll(2);

        assertThat(filter.deviation()).isGreaterThan(3 * before);
    }

    @Test
    void forgets() {
        watch(Translation2d.ORIGIN, new Translation2d(1, 0), 5);

        filter.reset();

        assertThat(filter.isKnown()).isFalse();
    }

    /** Shows a ball that rolls as balls roll on the pitch, with the noise of the camera. */
    private void watch(Translation2d from, Translation2d velocity, int pictures) {
        for (int i = 0; i < pictures; i++) {
            Translation2d truth = BallFilter.predict(from, velocity, i * PICTURE_SECONDS);
            if (filter.isKnown()) {
                filter.roll(PICTURE_SECONDS);
            }
            filter.see(truth.plus(new Translation2d(0.02 * noise.nextGaussian(), 0.02 * noise.nextGaussian())), 0.02);
        }
    }
}
