package org.robonewbie.learning.gym;

import java.util.Random;
import org.robonewbie.nao.Joint;

/** Errors of an episode that come on top of the readings of joints, gyro and accelerometer, for policies that must bear worse sensors. */
final class ReadingErrors {

    /** The readings as they are. */
    static final ReadingErrors NONE = new ReadingErrors(0, 0);

    private static final int READINGS = Joint.COUNT + 6;

    private final double deviation;
    private final Random random;

    /** Draws normally distributed errors with a standard deviation in the units of the readings. */
    ReadingErrors(double deviation, long seed) {
        this.deviation = deviation;
        this.random = new Random(31 * ~seed + 5);
    }

    /** Adds errors to a row that begins as {@link Perception} has it, and returns the same row. */
    double[] added(double[] row) {
        if (deviation > 0) {
            for (int i = 0; i < READINGS; i++) {
                row[i] += deviation * random.nextGaussian();
            }
        }
        return row;
    }
}
