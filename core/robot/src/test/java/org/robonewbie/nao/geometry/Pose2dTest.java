package org.robonewbie.nao.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;

class Pose2dTest {

    private static final double TINY = 1e-9;

    @Test
    void movesAlongItsOwnAxesAndThenTurns() {
        Pose2d pose = new Pose2d(1, 0, 90).then(2, 0.5, 30);

        assertThat(pose.x()).isCloseTo(0.5, within(TINY));
        assertThat(pose.y()).isCloseTo(2, within(TINY));
        assertThat(pose.degrees()).isCloseTo(120, within(TINY));
    }

    @Test
    void seesWhatIsInItsFrame() {
        Pose2d pose = new Pose2d(1, 2, 37);
        Vector3 point = new Vector3(-3, 0.5, 0.8);

        assertThat(pose.toFrame(pose.fromFrame(point)).distanceTo(point)).isLessThan(TINY);
        assertThat(new Pose2d(1, 0, 90).fromFrame(new Vector3(1, 2, 0)).distanceTo(new Vector3(2, 0, 0)))
                .isLessThan(TINY);
    }

    @Test
    void interpolatesWithoutWrapping() {
        Pose2d between = new Pose2d(0, 0, 170).interpolate(new Pose2d(1, 2, 190), 0.5);

        assertThat(between).isEqualTo(new Pose2d(0.5, 1, 180));
    }

    @Test
    void seesAPointByDistanceAndBearing() {
        Pose2d pose = new Pose2d(1, 2, 170);
        Vector3 point = pose.point(3, 40, 0.5);

        assertThat(pose.distance(point)).isCloseTo(3, within(TINY));
        assertThat(pose.bearing(point)).isCloseTo(40, within(TINY));
        assertThat(pose.pointAt(pose.ahead(point), pose.left(point)).distanceTo(new Vector3(point.x(), point.y(), 0)))
                .isLessThan(TINY);
    }
}
