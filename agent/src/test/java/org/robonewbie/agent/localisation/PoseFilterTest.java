package org.robonewbie.agent.localisation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;

class PoseFilterTest {

    private static final Pose CAMERA = new Pose(new Vector3(0, 0, 0.15), Rotation.NONE);
    private static final Landmark[] BEFORE_IT = {
        Landmark.GOAL_POST_1_RIGHT, Landmark.GOAL_POST_2_RIGHT, Landmark.FLAG_1_RIGHT, Landmark.FLAG_2_RIGHT
    };

    private final PoseFilter filter = new PoseFilter();

    @BeforeEach
    void begin() {
        filter.begin(new GroundPose(1, 1, 10), 0.5, 5);
    }

    @Test
    void findsPlaceHeadingHeightAndTiltByLandmarks() {
        for (int i = 0; i < 60; i++) {
            see(new Vector3(1.4, 0.7, 0.33), 16, 6, -4);
        }

        assertThat(filter.pose().x()).isCloseTo(1.4, within(0.02));
        assertThat(filter.pose().y()).isCloseTo(0.7, within(0.02));
        assertThat(filter.pose().headingDegrees()).isCloseTo(16, within(0.3));
        assertThat(filter.height()).isCloseTo(0.33, within(0.02));
        assertThat(filter.leanDegrees()).isCloseTo(6, within(0.5));
        assertThat(filter.rollDegrees()).isCloseTo(-4, within(0.5));
    }

    @Test
    void movesAlongItsHeading() {
        filter.begin(new GroundPose(1, 1, 90), 0.1, 1);

        filter.move(0.5, 0.2, new Vector3(1, 2, 20));

        assertThat(filter.pose().x()).isCloseTo(0.8, within(1e-9));
        assertThat(filter.pose().y()).isCloseTo(1.5, within(1e-9));
        assertThat(filter.pose().headingDegrees()).isCloseTo(110, within(1e-9));
        assertThat(filter.leanDegrees()).isEqualTo(2);
        assertThat(filter.rollDegrees()).isEqualTo(1);
    }

    @Test
    void doesNotBelieveALandmarkThatCannotBeThere() {
        filter.begin(new GroundPose(1, 1, 10), 0.01, 0.5);
        Vector3 post = SoccerField.BEGINNER.position(Landmark.GOAL_POST_1_RIGHT);

        filter.see(post, new Direction(1, -120, 0), CAMERA);

        assertThat(filter.pose().x()).isCloseTo(1, within(1e-6));
        assertThat(filter.pose().headingDegrees()).isCloseTo(10, within(1e-6));
    }

    @Test
    void believesWhatItSeesAgainOnceItDoubts() {
        filter.begin(new GroundPose(-2, -1, 100), 0.01, 0.5);

        for (int i = 0; i < 60; i++) {
            filter.doubt();
            see(new Vector3(1.4, 0.7, 0.36), 16, 0, 0);
        }

        assertThat(filter.pose().x()).isCloseTo(1.4, within(0.05));
        assertThat(filter.pose().y()).isCloseTo(0.7, within(0.05));
    }

    @Test
    void learnsFromWhereGravityPulls() {
        for (int i = 0; i < 200; i++) {
            filter.feel(5, -3);
        }

        assertThat(filter.leanDegrees()).isBetween(2.0, 5.0);
        assertThat(filter.rollDegrees()).isBetween(-3.0, -1.0);
    }

    private void see(Vector3 place, double heading, double lean, double roll) {
        Pose torso = new Pose(place, Rotation.ofYawPitchRoll(heading, lean, roll));
        Pose eye = torso.times(CAMERA).inverse();
        for (Landmark landmark : BEFORE_IT) {
            Vector3 map = SoccerField.BEGINNER.position(landmark);
            filter.see(map, Direction.of(eye.transform(map)), CAMERA);
        }
    }
}
