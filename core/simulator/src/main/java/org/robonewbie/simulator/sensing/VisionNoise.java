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
 * The errors of one camera: a displacement that stays the same for its whole life, and normally distributed errors of every
 * single measurement (SimSpark: {@code restrictedvisionperceptor.cpp}, {@code naoneckhead.rsg}).
 *
 * <p>Normal numbers are made by the polar method of Marsaglia and Bray from {@code nextDouble()} and {@link PortableMath}, so
 * that a seed gives the same numbers everywhere.
 */
final class VisionNoise implements Restorable {

    private static final double CALIBRATION_ERROR = 0.005;
    private static final double DISTANCE_SIGMA_PERCENT = 0.0965;
    private static final double HORIZONTAL_SIGMA_DEGREES = 0.1480;
    private static final double VERTICAL_SIGMA_DEGREES = 0.1225;

    private final RandomGenerator random;
    private Vector3 displacement;
    private double spare;
    private boolean hasSpare;

    VisionNoise(RandomGenerator random) {
        this.random = random;
        this.displacement = new Vector3(uniform(), uniform(), uniform());
    }

    Vector3 displacement() {
        return displacement;
    }

    /** Measures with errors what is at an exact place. */
    PolarPosition disturb(double metres, double horizontalDegrees, double verticalDegrees) {
        return new PolarPosition(
                metres + metres * normal() * DISTANCE_SIGMA_PERCENT / 100,
                horizontalDegrees + normal() * HORIZONTAL_SIGMA_DEGREES,
                verticalDegrees + normal() * VERTICAL_SIGMA_DEGREES);
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
        double factor = Math.sqrt(-2 * PortableMath.log(square) / square);
        spare = y * factor;
        hasSpare = true;
        return x * factor;
    }

    @Override
    public void save(StateWriter out) {
        restorableRandom().save(out);
        out.putVector(displacement);
        out.putDouble(spare);
        out.putBoolean(hasSpare);
    }

    @Override
    public void restore(StateReader in) {
        restorableRandom().restore(in);
        displacement = in.getVector();
        spare = in.getDouble();
        hasSpare = in.getBoolean();
    }

    private Restorable restorableRandom() {
        if (random instanceof Restorable restorable) {
            return restorable;
        }
        throw new UnsupportedOperationException("The random numbers of this camera cannot be saved. Make it with "
                + SplittableRandomSource.class.getSimpleName() + " instead of "
                + random.getClass().getSimpleName() + ".");
    }
}
