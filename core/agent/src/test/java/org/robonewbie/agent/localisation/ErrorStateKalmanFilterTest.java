package org.robonewbie.agent.localisation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;

class ErrorStateKalmanFilterTest {

    private static final Pose CAMERA = new Pose(new Vector3(0, 0, 0.15), Rotation.NONE);
    private static final Vector3 GRAVITY = new Vector3(0, 0, 9.81);
    private static final Landmark[] BEFORE_IT = {
        Landmark.GOAL_POST_1_RIGHT, Landmark.GOAL_POST_2_RIGHT, Landmark.FLAG_1_RIGHT, Landmark.FLAG_2_RIGHT
    };

    private final ErrorStateKalmanFilter filter = new ErrorStateKalmanFilter();

    @BeforeEach
    void begin() {
        filter.begin(new Pose2d(1, 1, 10), 0.5, 5);
    }

    @Test
    void findsPlaceHeadingHeightAndTiltByLandmarks() {
        Pose truth = new Pose(new Vector3(1.4, 0.7, 0.33), Rotation.ofYawPitchRoll(16, 6, -4));

        for (int i = 0; i < 60; i++) {
            see(truth);
        }

        assertIs(truth, 0.02, 0.3);
    }

    @Test
    void findsItselfWhileItLiesOnItsBack() {
        Pose truth = new Pose(new Vector3(-0.5, 0.2, 0.1), Rotation.ofYawPitchRoll(0, -85, 0));
        filter.begin(new Pose2d(-0.6, 0.1, 0), 0.3, 3);
        for (int i = 0; i < 50; i++) {
            filter.move(
                    new Vector3(0, -85, 0),
                    Rotation.ofYawPitchRoll(0, -1.7 * i, 0).inverse().apply(GRAVITY));
        }

        for (int i = 0; i < 60; i++) {
            see(truth);
        }

        assertIs(truth, 0.03, 0.5);
    }

    @Test
    void turnsByTheGyroscopeAndSpeedsUpByTheAccelerometer() {
        filter.begin(new Pose2d(1, 1, 90), 0, 0);

        filter.move(new Vector3(0, 0, 1000), new Vector3(5, 0, 9.81));
        filter.move(Vector3.ZERO, GRAVITY);

        assertThat(filter.pose().degrees()).isCloseTo(110, within(1e-9));
        assertThat(filter.pose().x()).isCloseTo(1, within(1e-9));
        assertThat(filter.pose().y()).isCloseTo(1 + 2 * 5 * Cycle.SECONDS * Cycle.SECONDS, within(1e-9));
    }

    @Test
    void rollsOverInSpaceNotOnPaper() {
        filter.begin(new Pose2d(0, 0, 0), 0, 0);

        filter.move(new Vector3(0, 90 / Cycle.SECONDS, 0), GRAVITY);
        filter.move(new Vector3(0, 0, 180 / Cycle.SECONDS), GRAVITY);
        filter.move(new Vector3(0, 90 / Cycle.SECONDS, 0), GRAVITY);

        assertThat(Math.abs(filter.pose().degrees())).isCloseTo(180, within(1e-6));
        assertThat(filter.torso().rotation().apply(new Vector3(0, 0, 1)).z()).isCloseTo(1, within(1e-9));
    }

    @Test
    void doesNotBelieveALandmarkThatCannotBeThere() {
        filter.begin(new Pose2d(1, 1, 10), 0.01, 0.5);
        Vector3 post = SoccerField.BEGINNER.position(Landmark.GOAL_POST_1_RIGHT);

        boolean believed = filter.see(post, new Direction(1, -120, 0), CAMERA);

        assertThat(believed).isFalse();
        assertThat(filter.pose().x()).isCloseTo(1, within(1e-6));
        assertThat(filter.pose().degrees()).isCloseTo(10, within(1e-6));
    }

    @Test
    void learnsItsSpeedFromTheStandingFoot() {
        for (int i = 0; i < 200; i++) {
            filter.move(Vector3.ZERO, GRAVITY);
            filter.stand(0.4, 0, 0.36);
        }
        double before = filter.torso().position().x();
        filter.move(Vector3.ZERO, GRAVITY);

        double metresPerSecond = (filter.torso().position().x() - before) / Cycle.SECONDS;
        assertThat(metresPerSecond).isBetween(0.3, 0.45);
    }

    @Test
    void learnsItsTiltFromTheStandingFootAndThePushOfTheGround() {
        Vector3 up = Rotation.ofYawPitchRoll(0, 3, 0).inverse().apply(GRAVITY);

        for (int i = 0; i < 400; i++) {
            filter.move(Vector3.ZERO, up);
            filter.stand(0, 0, 0.36);
        }

        assertThat(filter.torso().rotation().apply(new Vector3(1, 0, 0)).z())
                .isCloseTo(-Math.sin(Math.toRadians(3)), within(0.01));
    }

    @Test
    void aBeamLeavesNoSpeed() {
        filter.move(Vector3.ZERO, new Vector3(4000, 0, 0));
        filter.move(Vector3.ZERO, GRAVITY);

        assertThat(filter.pose().x()).isEqualTo(1);
    }

    private void see(Pose torso) {
        Pose eye = torso.times(CAMERA).inverse();
        for (Landmark landmark : BEFORE_IT) {
            Vector3 map = SoccerField.BEGINNER.position(landmark);
            filter.see(map, Direction.of(eye.transform(map)), CAMERA);
        }
    }

    private void assertIs(Pose truth, double metres, double degrees) {
        Pose torso = filter.torso();
        assertThat(torso.position().distanceTo(truth.position())).isLessThan(metres);
        assertThat(torso.rotation().inverse().times(truth.rotation()).angleDegrees())
                .isLessThan(degrees);
    }
}
