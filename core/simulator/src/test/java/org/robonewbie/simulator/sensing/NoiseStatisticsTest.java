package org.robonewbie.simulator.sensing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RotationMatrix;
import org.robonewbie.simulator.sensing.Sightings.Kind;
import org.robonewbie.simulator.sensing.Sightings.Scatter;

/**
 * Compares all noise that agents of our server get over TCP with the recorded messages of a real rcssserver3d. All tests of
 * this class together refuse a server with the same noise once in a hundred times: each of about thirty comparisons has the
 * level 0.0003, which are 3.6 standard errors. Seeds are fixed, so that the result is always the same.
 */
class NoiseStatisticsTest {

    private static final double STANDARD_ERRORS = 3.6;

    /** Exceeded with probability 0.0003 by chance for 11 and 1 degrees of freedom. */
    private static final double CHI_SQUARE_11 = 34.6;

    private static final double CHI_SQUARE_1 = 13.1;

    private static final double DISTANCE_SIGMA = 0.000965;
    private static final double HORIZONTAL_SIGMA = 0.1480;
    private static final double VERTICAL_SIGMA = 0.1225;
    private static final double ROUNDING_SIGMA = 0.01 / Math.sqrt(12);
    private static final double CALIBRATION_LIMIT = 0.005;
    private static final double MIN_METRES = 2.8;
    private static final double BALL_HEIGHT = 0.04176;

    private static List<PerceptorMessage> ours = List.of();
    private static Sightings ourSightings = Sightings.of(List.of(), "", 0);
    private static List<Sightings> recorded = List.of();

    @BeforeAll
    static void collect() throws IOException {
        ours = NoisyScene.messages();
        ourSightings = Sightings.of(ours, NoisyScene.TEAM, 1);
        recorded = List.of(
                recorded("a_agent_100msgs_sync_fast_noise"),
                recorded("a_agent_100msgs_default_realtime_noise"),
                recorded("a_agent_two_teams_hear_playon_noise"));
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void horizontalAnglesScatterAsMuchAsRecorded(Kind kind) {
        Scatter theirs = recorded.stream()
                .map(sightings -> sightings.scatter(kind, PolarPosition::horizontalDegrees))
                .reduce(new Scatter(0, 0), Scatter::plus);

        assertSameVariance(ourSightings.scatter(kind, PolarPosition::horizontalDegrees), theirs);
    }

    @ParameterizedTest
    @EnumSource(Kind.class)
    void verticalAnglesScatterAsMuchAsRecorded(Kind kind) {
        Scatter theirs = recorded.stream()
                .map(sightings -> sightings.scatter(kind, PolarPosition::verticalDegrees))
                .reduce(new Scatter(0, 0), Scatter::plus);

        assertSameVariance(ourSightings.scatter(kind, PolarPosition::verticalDegrees), theirs);
    }

    /** The own arms are 0.18 m away, where the noise of 0.2 mm is lost by printing centimetres. */
    @ParameterizedTest
    @EnumSource(value = Kind.class, mode = EnumSource.Mode.EXCLUDE, names = "OWN_ARM")
    void distancesScatterAsMuchAsRecorded(Kind kind) {
        Scatter theirs = recorded.stream()
                .map(sightings -> distanceScatter(sightings, kind))
                .reduce(new Scatter(0, 0), Scatter::plus);

        assertSameVariance(distanceScatter(ourSightings, kind), theirs);
    }

    /** The means of five things, 15 numbers, fit to one place and heading of the camera: 11 degrees of freedom are left. */
    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 1, 2})
    void meansFitToOneCameraThatSeesWithoutBias(int recording) {
        Sightings sightings = recording < 0 ? ourSightings : recorded.get(recording);

        double[] camera =
                LeastSquares.fit(new double[] {-3, 0, 0.54, 0}, parameters -> landmarkResiduals(sightings, parameters));

        double[] residuals = landmarkResiduals(sightings, camera);
        assertThat(residuals).hasSize(15);
        assertThat(LeastSquares.chiSquare(residuals)).isLessThan(CHI_SQUARE_11);
    }

    /** The own arms are so near that they show the calibration error; four angles for three numbers. */
    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 1, 2})
    void calibrationErrorIsWithinFiveMillimetres(int recording) {
        Sightings sightings = recording < 0 ? ourSightings : recorded.get(recording);

        double[] displacement =
                LeastSquares.fit(new double[] {0, 0, 0}, parameters -> armResiduals(sightings, parameters));

        assertThat(LeastSquares.chiSquare(armResiduals(sightings, displacement)))
                .isLessThan(CHI_SQUARE_1);
        for (double component : displacement) {
            assertThat(component).isCloseTo(0, within(CALIBRATION_LIMIT + 0.001));
        }
    }

    @Test
    void nothingButPicturesIsNoisyWhileARobotRests() throws IOException {
        for (List<PerceptorMessage> messages :
                List.of(ours, atRest(RecordedMessages.read("a_agent_100msgs_sync_fast_noise")))) {
            PerceptorMessage first = messages.get(0);

            assertThat(messages).hasSizeGreaterThan(50).allSatisfy(message -> {
                assertThat(message.jointAngles()).isEqualTo(first.jointAngles());
                assertThat(message.gyro()).isEqualTo(first.gyro());
                assertThat(message.accelerometer()).isEqualTo(first.accelerometer());
                assertThat(message.footForces()).isEqualTo(first.footForces());
            });
        }
    }

    @Test
    void voicesComeFromExactlyOneDirectionWhileRobotsRest() throws IOException {
        for (List<PerceptorMessage> messages :
                List.of(ours, RecordedMessages.read("a_agent_two_teams_hear_playon_noise"))) {
            Map<String, List<Double>> directions = messages.stream()
                    .flatMap(message -> message.heard().stream())
                    .filter(heard -> !heard.isOwn())
                    .collect(Collectors.groupingBy(
                            heard -> heard.team().orElseThrow(),
                            Collectors.mapping(heard -> heard.directionDegrees().orElseThrow(), Collectors.toList())));

            assertThat(directions).containsOnlyKeys("Alpha", "Beta");
            assertThat(directions.values()).allSatisfy(values -> {
                assertThat(values).hasSizeGreaterThan(4);
                assertThat(values).containsOnly(values.get(0));
            });
        }
    }

    /** The variance of an even distribution is a third of its limit's square; its estimate has the error 0.89 / sqrt(n). */
    @Test
    void beamsAreEvenlySpreadWithinFiveCentimetresAndTenDegrees() throws IOException {
        List<double[]> errors = NoisyScene.beamErrors();
        double[] limits = {0.05, 0.05, 10};

        for (int i = 0; i < limits.length; i++) {
            int component = i;
            double[] values =
                    errors.stream().mapToDouble(error -> error[component]).toArray();
            double mean = Arrays.stream(values).average().orElseThrow();
            double variance = Arrays.stream(values).map(value -> value * value).sum() / values.length;
            double expected = limits[i] * limits[i] / 3;
            double largest = Arrays.stream(values).map(Math::abs).max().orElseThrow();
            assertThat(values).hasSizeGreaterThan(300);
            assertThat(largest).isLessThan(limits[component] + 1e-3);
            assertThat(mean).isCloseTo(0, within(STANDARD_ERRORS * Math.sqrt(expected / values.length)));
            assertThat(variance)
                    .isCloseTo(expected, within(STANDARD_ERRORS * expected * 0.89 / Math.sqrt(values.length)));
        }
    }

    private static Scatter distanceScatter(Sightings sightings, Kind kind) {
        return sightings.distanceScatter(kind, MIN_METRES, DISTANCE_SIGMA, ROUNDING_SIGMA);
    }

    /** The logarithm of an estimated sigma has a standard error of one by the root of twice the degrees of freedom. */
    private static void assertSameVariance(Scatter one, Scatter two) {
        double standardError = Math.sqrt(0.5 / one.degreesOfFreedom() + 0.5 / two.degreesOfFreedom());
        assertThat(two.degreesOfFreedom()).isGreaterThan(50);
        assertThat(Math.log(one.sigma() / two.sigma())).isCloseTo(0, within(STANDARD_ERRORS * standardError));
    }

    private static double[] landmarkResiduals(Sightings sightings, double[] camera) {
        List<Double> residuals = new ArrayList<>();
        for (Map.Entry<String, List<PolarPosition>> seen :
                sightings.of(Kind.LANDMARK).entrySet()) {
            Vector3 place = SoccerField.LEAGUE.position(Landmark.valueOf(seen.getKey()));
            addResiduals(seen.getValue(), fromCamera(place, camera), residuals);
        }
        addResiduals(
                Objects.requireNonNull(sightings.of(Kind.BALL).get("ball")),
                fromCamera(new Vector3(0, 0, BALL_HEIGHT), camera),
                residuals);
        return residuals.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double[] armResiduals(Sightings sightings, double[] displacement) {
        Vector3 error = new Vector3(displacement[0], displacement[1], displacement[2]);
        List<Double> residuals = new ArrayList<>();
        sightings.of(Kind.OWN_ARM).forEach((name, seen) -> {
            BodyPart part = name.endsWith("LEFT_LOWER_ARM") ? BodyPart.LEFT_LOWER_ARM : BodyPart.RIGHT_LOWER_ARM;
            List<Double> all = new ArrayList<>();
            addResiduals(seen, NoisyScene.fromHead(part).plus(error), all);
            residuals.addAll(all.subList(1, 3));
        });
        return residuals.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** A camera is its place and its heading in radians, with the robot's axes x right, y forward, z up. */
    private static Vector3 fromCamera(Vector3 place, double[] camera) {
        BodyPose pose = new BodyPose(
                new Vector3(camera[0], camera[1], camera[2]), RotationMatrix.aboutZ(camera[3] - Math.PI / 2));
        return pose.rotation().inverse().apply(place.minus(pose.position()));
    }

    private static void addResiduals(List<PolarPosition> seen, Vector3 local, List<Double> residuals) {
        PolarPosition mean = Sightings.mean(seen);
        double root = Math.sqrt(seen.size());
        double distance = local.length();
        double horizontal = Math.toDegrees(Math.atan2(-local.x(), local.y()));
        double vertical = Math.toDegrees(Math.atan2(local.z(), Math.hypot(local.x(), local.y())));
        residuals.add(
                (mean.distanceMetres() - distance) / Math.hypot(DISTANCE_SIGMA * distance, ROUNDING_SIGMA) * root);
        residuals.add((mean.horizontalDegrees() - horizontal) / HORIZONTAL_SIGMA * root);
        residuals.add((mean.verticalDegrees() - vertical) / VERTICAL_SIGMA * root);
    }

    private static Sightings recorded(String name) throws IOException {
        List<PerceptorMessage> messages = RecordedMessages.read(name);
        return name.contains("two_teams") ? Sightings.of(messages, "Alpha", 1) : Sightings.of(atRest(messages), "X", 1);
    }

    private static List<PerceptorMessage> atRest(List<PerceptorMessage> messages) {
        return messages.subList(40, messages.size());
    }
}
