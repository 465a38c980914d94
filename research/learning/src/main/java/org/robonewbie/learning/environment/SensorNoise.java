package org.robonewbie.learning.environment;

import java.util.Random;
import org.robonewbie.nao.Joint;

/** Additional sensor noise of an episode: normally distributed, on joint angles, gyroscope and accelerometer. */
final class SensorNoise {

    /** No additional noise. */
    static final SensorNoise NONE = new SensorNoise(0, 0);

    private static final int READINGS = Joint.COUNT + 6;

    private final double sigma;
    private final Random random;

    /** Creates noise with a standard deviation in the units of the readings. */
    SensorNoise(double sigma, long seed) {
        this.sigma = sigma;
        this.random = new Random(31 * ~seed + 5);
    }

    /** Adds noise to a row in the order of {@link Perception}, and returns the same row. */
    double[] added(double[] row) {
        if (sigma > 0) {
            for (int i = 0; i < READINGS; i++) {
                row[i] += sigma * random.nextGaussian();
            }
        }
        return row;
    }
}
