package org.robonewbie.simulator.sensing;

import java.util.random.RandomGenerator;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.PolarPosition;

/**
 * The errors of one camera: a displacement that stays the same for its whole life, and normally distributed errors of every
 * single measurement (SimSpark: {@code restrictedvisionperceptor.cpp}, {@code naoneckhead.rsg}).
 *
 * <p>Normal numbers are made by the polar method of Marsaglia and Bray from {@code nextDouble()} and {@link StrictMath}, so
 * that a seed gives the same numbers in every Java.
 */
final class VisionNoise {

    private static final double CALIBRATION_ERROR = 0.005;
    private static final double DISTANCE_SIGMA_PERCENT = 0.0965;
    private static final double HORIZONTAL_SIGMA_DEGREES = 0.1480;
    private static final double VERTICAL_SIGMA_DEGREES = 0.1225;

    private final RandomGenerator random;
    private final Vector3 displacement;
    private double spare;
    private boolean hasSpare;

    VisionNoise(RandomGenerator random) {
        this.random = random;
        this.displacement = new Vector3(uniform(), uniform(), uniform());
    }

    Vector3 displacement() {
        return displacement;
    }

    PolarPosition disturb(PolarPosition exact) {
        double distance = exact.distanceMetres();
        return new PolarPosition(
                distance + distance * normal() * DISTANCE_SIGMA_PERCENT / 100,
                exact.horizontalDegrees() + normal() * HORIZONTAL_SIGMA_DEGREES,
                exact.verticalDegrees() + normal() * VERTICAL_SIGMA_DEGREES);
    }

    private double uniform() {
        return (2 * random.nextDouble() - 1) * CALIBRATION_ERROR;
    }

    private double normal() {
        if (hasSpare) {
            hasSpare = false;
            return spare;
        }
        double x;
        double y;
        double square;
        do {
            x = 2 * random.nextDouble() - 1;
            y = 2 * random.nextDouble() - 1;
            square = x * x + y * y;
        } while (square >= 1 || square == 0);
        double factor = StrictMath.sqrt(-2 * StrictMath.log(square) / square);
        spare = y * factor;
        hasSpare = true;
        return x * factor;
    }
}
