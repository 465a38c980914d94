package org.robonewbie.simulator.sensing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;

/**
 * Compares the scatter of our camera and of a real rcssserver3d with the same three sigmas. The tolerance is 3.3 standard
 * errors of an estimated sigma, which a right implementation exceeds once in a thousand times.
 */
class VisionNoiseTest {

    private static final double DISTANCE_SIGMA = 0.000965;
    private static final double HORIZONTAL_SIGMA = 0.1480;
    private static final double VERTICAL_SIGMA = 0.1225;
    private static final double STANDARD_ERRORS = 3.3;

    @Test
    void singleMeasurementsScatterWithTheOriginalsSigmas() {
        VisionNoise noise = new VisionNoise(new SplittableRandom(3));
        Scatter distance = new Scatter();
        Scatter horizontal = new Scatter();
        Scatter vertical = new Scatter();

        for (int i = 0; i < 20_000; i++) {
            PolarPosition disturbed = noise.disturb(10, 20, -5);
            distance.add(disturbed.distanceMetres() / 10 - 1);
            horizontal.add(disturbed.horizontalDegrees() - 20);
            vertical.add(disturbed.verticalDegrees() + 5);
        }

        distance.assertNoBias();
        horizontal.assertNoBias();
        vertical.assertNoBias();
        distance.assertSigma(DISTANCE_SIGMA, 20_000);
        horizontal.assertSigma(HORIZONTAL_SIGMA, 20_000);
        vertical.assertSigma(VERTICAL_SIGMA, 20_000);
    }

    @Test
    void recordedMeasurementsScatterWithTheSameSigmas() throws IOException {
        List<List<PolarPosition>> objects = recordedObjects();
        Scatter distance = new Scatter();
        Scatter horizontal = new Scatter();
        Scatter vertical = new Scatter();
        int degreesOfFreedom = 0;

        for (List<PolarPosition> object : objects) {
            double meanDistance = mean(
                    object.stream().mapToDouble(PolarPosition::distanceMetres).toArray());
            double meanHorizontal = mean(object.stream()
                    .mapToDouble(PolarPosition::horizontalDegrees)
                    .toArray());
            double meanVertical = mean(
                    object.stream().mapToDouble(PolarPosition::verticalDegrees).toArray());
            degreesOfFreedom += object.size() - 1;
            for (PolarPosition position : object) {
                distance.add(position.distanceMetres() / meanDistance - 1);
                horizontal.add(position.horizontalDegrees() - meanHorizontal);
                vertical.add(position.verticalDegrees() - meanVertical);
            }
        }

        assertThat(objects).hasSize(4);
        distance.assertSigma(DISTANCE_SIGMA, degreesOfFreedom);
        horizontal.assertSigma(HORIZONTAL_SIGMA, degreesOfFreedom);
        vertical.assertSigma(VERTICAL_SIGMA, degreesOfFreedom);
    }

    @Test
    void calibrationErrorIsEvenlySpreadWithinFiveMillimetres() {
        SplittableRandom random = new SplittableRandom(4);
        Scatter x = new Scatter();

        for (int i = 0; i < 2000; i++) {
            Vector3 displacement = new VisionNoise(random).displacement();
            assertThat(displacement.x()).isBetween(-0.005, 0.005);
            assertThat(displacement.y()).isBetween(-0.005, 0.005);
            assertThat(displacement.z()).isBetween(-0.005, 0.005);
            x.add(displacement.x());
        }

        x.assertNoBias();
        x.assertSigma(0.01 / Math.sqrt(12), 2000);
    }

    /** All pictures of the posts and flags after the robot has come to rest. */
    private static List<List<PolarPosition>> recordedObjects() throws IOException {
        List<PerceptorMessage> messages = RecordedMessages.read("a_agent_100msgs_sync_fast_noise");
        List<List<PolarPosition>> objects = new ArrayList<>();
        for (PerceptorMessage message : messages.subList(25, messages.size())) {
            if (message.vision().isEmpty()) {
                continue;
            }
            for (int i = 0; i < message.vision().get().landmarks().size(); i++) {
                if (objects.size() <= i) {
                    objects.add(new ArrayList<>());
                }
                objects.get(i).add(message.vision().get().landmarks().get(i).position());
            }
        }
        return objects;
    }

    private static double mean(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value;
        }
        return sum / values.length;
    }

    /** Sum and sum of squares of deviations. */
    private static final class Scatter {

        private double sum;
        private double squares;
        private int count;

        void add(double deviation) {
            sum += deviation;
            squares += deviation * deviation;
            count++;
        }

        void assertNoBias() {
            double sigma = Math.sqrt(squares / count);
            assertThat(sum / count).isCloseTo(0, within(STANDARD_ERRORS * sigma / Math.sqrt(count)));
        }

        void assertSigma(double expected, int degreesOfFreedom) {
            double sigma = Math.sqrt(squares / degreesOfFreedom);
            double standardError = expected / Math.sqrt(2.0 * degreesOfFreedom);
            assertThat(sigma).isCloseTo(expected, within(STANDARD_ERRORS * standardError));
        }
    }
}
