package org.robonewbie.nao.motion;

import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Where the ball must lie before a kick. A motion file states it in its comment {@code // ball:}, see {@link MotionFile#ball}.
 *
 * @param ahead metres ahead of the torso
 * @param left metres to the left of the torso
 */
public record BallPlace(double ahead, double left) {

    private static final Pattern TEXT = Pattern.compile("(-?[0-9.]+) m ahead, (-?[0-9.]+) m to the left");
    private static final double ERROR = 0.01;

    /**
     * Reads the text that {@link #toString} writes.
     *
     * @param text such as {@code 0.190 m ahead, -0.055 m to the left}
     * @return the place; empty if the text names none
     * @throws NumberFormatException if one of the distances is no number
     */
    public static Optional<BallPlace> parse(String text) {
        Matcher place = TEXT.matcher(text);
        return place.find()
                ? Optional.of(new BallPlace(Double.parseDouble(place.group(1)), Double.parseDouble(place.group(2))))
                : Optional.empty();
    }

    /** {@return the place before the other foot} */
    public BallPlace mirrored() {
        return new BallPlace(ahead, -left);
    }

    /**
     * Draws a place close to this one.
     *
     * @param random chooses it
     * @return a place up to 1 cm away from this one along each axis
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
