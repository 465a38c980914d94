package org.robonewbie.learning.trial;

import java.util.Locale;
import java.util.Random;

/**
 * Where a ball lies before a kick.
 *
 * @param ahead metres ahead of the torso
 * @param left metres to the left of the torso
 */
public record BallPlace(double ahead, double left) {

    private static final double ERROR = 0.01;

    /**
     * Reads what {@link #toString} has written.
     *
     * @param text such as {@code 0.190 m ahead, -0.055 m to the left}
     * @return the place
     */
    public static BallPlace of(String text) {
        String[] words = text.trim().split("\\s+", -1);
        return new BallPlace(Double.parseDouble(words[0]), Double.parseDouble(words[3]));
    }

    /**
     * Exchanges left and right.
     *
     * @return the place before the other foot
     */
    public BallPlace mirrored() {
        return new BallPlace(ahead, -left);
    }

    /**
     * Draws a place that is not quite the right one.
     *
     * @param random chooses it
     * @return a place up to 1 cm beside this one along each axis
     */
    public BallPlace near(Random random) {
        return new BallPlace(
                ahead + ERROR * (2 * random.nextDouble() - 1), left + ERROR * (2 * random.nextDouble() - 1));
    }

    @Override
    public String toString() {
        return String.format(Locale.ROOT, "%.3f m ahead, %.3f m to the left", ahead, left);
    }
}
