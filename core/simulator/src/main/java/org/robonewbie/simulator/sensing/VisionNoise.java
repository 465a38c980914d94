package org.robonewbie.simulator.sensing;

import java.util.random.RandomGenerator;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.simulator.state.SplittableRandomSource;

/**
 * Noise model of a camera: a constant calibration error, and Gaussian noise for each measurement (SimSpark: {@code
 * restrictedvisionperceptor.cpp}, {@code naoneckhead.rsg}).
 *
 * <p>Gaussian values come from Marsaglia's polar method with {@code nextDouble()} and {@link PortableMath}, so that a
 * seed produces the same values on every platform.
 */
final class VisionNoise implements Restorable {

    private static final double CALIBRATION_ERROR = 0.005;
    private static final double DISTANCE_SIGMA_PERCENT = 0.0965;
    private static final double HORIZONTAL_SIGMA_DEGREES = 0.1480;
    private static final double VERTICAL_SIGMA_DEGREES = 0.1225;

    private final RandomGenerator random;
    private Vector3 displacement;
    private double spareGaussian;
    private boolean hasSpareGaussian;

    VisionNoise(RandomGenerator random) {
        this.random = random;
        this.displacement = new Vector3(uniform(), uniform(), uniform());
    }

    Vector3 displacement() {
        return displacement;
    }

    /** Adds noise to a measurement. */
    PolarPosition disturb(double metres, double horizontalDegrees, double verticalDegrees) {
        return new PolarPosition(
                metres + metres * gaussian() * DISTANCE_SIGMA_PERCENT / 100,
                horizontalDegrees + gaussian() * HORIZONTAL_SIGMA_DEGREES,
                verticalDegrees + gaussian() * VERTICAL_SIGMA_DEGREES);
    }

    private double uniform() {
        return (2 * random.nextDouble() - 1) * CALIBRATION_ERROR;
    }

    private double gaussian() {
        if (hasSpareGaussian) {
            hasSpareGaussian = false;
            return spareGaussian;
        }
        double x;
        double y;
        double square;
        do {
            x = 2 * random.nextDouble() - 1;
            y = 2 * random.nextDouble() - 1;
            square = x * x + y * y;
        } while (square >= 1 || square == 0);
        double factor = Math.sqrt(-2 * PortableMath.log(square) / square);
        spareGaussian = y * factor;
        hasSpareGaussian = true;
        return x * factor;
    }

    @Override
    public void save(StateWriter out) {
        restorableRandom().save(out);
        out.putVector(displacement);
        out.putDouble(spareGaussian);
        out.putBoolean(hasSpareGaussian);
    }

    @Override
    public void restore(StateReader in) {
        restorableRandom().restore(in);
        displacement = in.getVector();
        spareGaussian = in.getDouble();
        hasSpareGaussian = in.getBoolean();
    }

    private Restorable restorableRandom() {
        if (random instanceof Restorable restorable) {
            return restorable;
        }
        throw new UnsupportedOperationException(
                "The camera cannot be saved with a " + random.getClass().getSimpleName() + ". Use a "
                        + SplittableRandomSource.class.getSimpleName() + " instead.");
    }
}
