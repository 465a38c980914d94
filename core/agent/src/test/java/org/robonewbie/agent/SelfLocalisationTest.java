package org.robonewbie.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;

class SelfLocalisationTest {

    private static final SoccerField FIELD = SoccerField.BEGINNER;

    /** Height of the camera of a robot with straight legs. */
    private static final double CAMERA_METRES = 0.54;

    private final SelfLocalisation self = new SelfLocalisation(FIELD);
    private final AgentDriver agent = new AgentDriver(new Agent() {
        @Override
        protected void think() {
            self.update(nao, fieldView);
        }
    });

    @Test
    void findsItsPlaceByTwoLandmarks() {
        Pose2d truth = new Pose2d(1.5, -0.7, 20);

        agent.respond(seeing(truth, TeamSide.LEFT, 1, Landmark.GOAL_POST_1_RIGHT, Landmark.FLAG_2_RIGHT));

        assertIs(truth, 1e-9);
        assertThat(self.isKnown()).isTrue();
        assertThat(self.ageSeconds()).isZero();
    }

    @Test
    void recognisesThePitchOfTheLeagueByTheDistancesOfItsLandmarks() {
        SelfLocalisation unsure = new SelfLocalisation();
        Pose2d truth = new Pose2d(9, -3, 30);
        List<Vision.SeenLandmark> seen = List.of(
                sighting(SoccerField.LEAGUE, truth, Landmark.GOAL_POST_1_RIGHT),
                sighting(SoccerField.LEAGUE, truth, Landmark.FLAG_1_RIGHT));

        rehearse(unsure, seen);

        assertThat(unsure.field()).isEqualTo(SoccerField.LEAGUE);
        assertThat(unsure.pose().x()).isCloseTo(9, within(1e-6));
        assertThat(unsure.pose().y()).isCloseTo(-3, within(1e-6));
    }

    @Test
    void doesNotGuessThePitchByOneLandmark() {
        SelfLocalisation unsure = new SelfLocalisation();
        unsure.setPose(new Pose2d(-1, 0, 0));

        rehearse(unsure, List.of(sighting(SoccerField.LEAGUE, Pose2d.ORIGIN, Landmark.FLAG_1_RIGHT)));

        assertThat(unsure.field()).isEqualTo(SoccerField.BEGINNER);
        assertThat(unsure.pose().x()).isCloseTo(-1, within(1e-6));
    }

    @Test
    void usesTheOwnTeamsCoordinatesOnTheRightSideToo() {
        Pose2d truth = new Pose2d(-2, 1, -10);

        agent.respond(seeing(truth, TeamSide.RIGHT, 1, Landmark.GOAL_POST_1_LEFT, Landmark.GOAL_POST_2_LEFT));

        assertIs(truth, 1e-9);
    }

    @Test
    void doesNotBelieveToKnowItsPlaceByOneLandmark() {
        agent.respond(seeing(Pose2d.ORIGIN, TeamSide.LEFT, 1, Landmark.FLAG_1_RIGHT));

        assertThat(self.isKnown()).isFalse();
        assertThat(self.ageSeconds()).isInfinite();
    }

    @Test
    void isDrawnToItsTruePlaceByOneLandmarkIfItKnowsItsDirection() {
        Pose2d truth = new Pose2d(1, 1, 0);
        self.setPose(new Pose2d(0.5, 0.8, 0));

        for (int i = 0; i < 60; i++) {
            agent.respond(seeing(truth, TeamSide.LEFT, 1 + 0.02 * i, Landmark.FLAG_1_RIGHT));
        }

        assertIs(truth, 0.03);
    }

    @Test
    void findsItsPlaceAgainAfterItWasCarriedAway() {
        Pose2d there = new Pose2d(-2, -1, 120);
        for (int i = 0; i < 10; i++) {
            agent.respond(seeing(
                    new Pose2d(1, 1, 0), TeamSide.LEFT, 1 + 0.02 * i, Landmark.FLAG_1_RIGHT, Landmark.FLAG_2_RIGHT));
        }

        for (int i = 10; i < 40; i++) {
            agent.respond(seeing(there, TeamSide.LEFT, 1 + 0.02 * i, Landmark.FLAG_1_LEFT, Landmark.GOAL_POST_1_LEFT));
        }

        assertIs(there, 0.03);
    }

    @Test
    void knowsThatItLiesOnItsBack() {
        self.setPose(new Pose2d(1, 1, 90));

        for (int i = 0; i < 50; i++) {
            double degrees = 1.8 * i;
            double along = 9.81 * Math.cos(Math.toRadians(degrees));
            double ahead = 9.81 * Math.sin(Math.toRadians(degrees));
            agent.respond(Messages.standing()
                    .at(1 + 0.02 * i)
                    .gyro(90, 0, 0)
                    .accelerometer(0, ahead, along)
                    .build());
        }

        assertThat(self.leanDegrees()).isCloseTo(-90, within(1.0));
        assertThat(self.tiltDegrees()).isCloseTo(90, within(1.0));
    }

    @Test
    void turnsByTheGyroscopeWhileItSeesNothing() {
        self.setPose(Pose2d.ORIGIN);

        for (int i = 0; i < 50; i++) {
            agent.respond(Messages.standing().at(1 + 0.02 * i).gyro(0, 0, 45).build());
        }

        assertThat(self.pose().degrees()).isCloseTo(45, within(1e-6));
        assertThat(self.odometry().pose().degrees()).isCloseTo(45, within(1e-6));
    }

    @Test
    void knowsWhereTheBallIsAfterItHasTurnedAway() {
        Vision ball = Vision.of(List.of(), Optional.of(new PolarPosition(2, 0, 0)), List.of(), List.of());
        Vector3[] now = {Vector3.ZERO};
        AgentDriver turning = new AgentDriver(new Agent() {
            @Override
            protected void think() {
                self.update(nao, fieldView);
                now[0] = self.odometry().positionNow(fieldView.ball());
            }
        });

        turning.respond(Messages.standing().at(1).seeing(ball).build());
        for (int i = 1; i <= 50; i++) {
            turning.respond(Messages.standing().at(1 + 0.02 * i).gyro(0, 0, 90).build());
        }

        assertThat(now[0].distanceTo(new Vector3(0, -2, 0))).isLessThan(1e-6);
    }

    private void assertIs(Pose2d truth, double tolerance) {
        assertThat(self.pose().x()).isCloseTo(truth.x(), within(tolerance));
        assertThat(self.pose().y()).isCloseTo(truth.y(), within(tolerance));
        assertThat(self.pose().degrees()).isCloseTo(truth.degrees(), within(tolerance * 100));
    }

    private static PerceptorMessage seeing(Pose2d truth, TeamSide side, double seconds, Landmark... landmarks) {
        List<Vision.SeenLandmark> seen = Arrays.stream(landmarks)
                .map(landmark -> new Vision.SeenLandmark(landmark, polar(truth, side, landmark)))
                .toList();
        return Messages.standing()
                .at(seconds)
                .on(side)
                .seeing(Vision.of(seen, Optional.empty(), List.of(), List.of()))
                .build();
    }

    private static void rehearse(SelfLocalisation localisation, List<Vision.SeenLandmark> seen) {
        AgentDriver looking = new AgentDriver(new Agent() {
            @Override
            protected void think() {
                localisation.update(nao, fieldView);
            }
        });
        looking.respond(Messages.standing()
                .at(1)
                .seeing(Vision.of(seen, Optional.empty(), List.of(), List.of()))
                .build());
    }

    private static Vision.SeenLandmark sighting(SoccerField field, Pose2d truth, Landmark landmark) {
        return new Vision.SeenLandmark(landmark, polar(truth, field.position(landmark)));
    }

    private static PolarPosition polar(Pose2d truth, TeamSide side, Landmark landmark) {
        return polar(truth, FIELD.position(landmark).times(side == TeamSide.LEFT ? 1 : -1));
    }

    private static PolarPosition polar(Pose2d truth, Vector3 place) {
        Vector3 seen = truth.fromFrame(place).minus(new Vector3(0, 0, CAMERA_METRES));
        Direction direction = Direction.of(seen);
        return new PolarPosition(direction.distance(), direction.bearing(), direction.elevation());
    }
}
