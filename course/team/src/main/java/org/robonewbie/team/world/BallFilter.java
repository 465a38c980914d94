package org.robonewbie.team.world;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.math.PortableMath;

/**
 * Estimates where the ball is and how fast it rolls: a Kalman filter.
 *
 * <p>The model. Grass brakes the ball the more the faster it is, so that its speed falls by the same share in each second: v(t) = v₀
 * e<sup>−t/τ</sup>, and it rolls on by v₀ τ (1 − e<sup>−t/τ</sup>), in all τ = 0.677 s times its speed. That is linear, as Kalman's
 * filter wants it.
 *
 * <p>The filter. It knows position and speed, and how uncertain both are. {@link #roll} lets the ball roll on: the estimate moves,
 * and its uncertainty grows. {@link #see} mixes in what the camera shows; the less certain the estimate, the more the picture counts.
 * A picture that does not fit at all means that somebody has kicked: then the speed is anybody's guess until the next picture.
 *
 * <p>Both axes have the same uncertainty, so three numbers are enough instead of a matrix: the variance of the position, that of the
 * speed, and what they have in common.
 *
 * <p>Source: R. E. Kalman, <em>A new approach to linear filtering and prediction problems</em>, 1960.
 */
public final class BallFilter {

    /** For each metre per second the ball rolls on by so many metres, until it lies still. */
    public static final double ROLLING_SECONDS = 0.677;

    private static final double SPEED_NOISE = 0.5;
    private static final double POSITION_NOISE = 0.0004;
    private static final double SURPRISE = 16;
    private static final double KICKED_VARIANCE = 6;
    private static final double FIRST_VARIANCE = 0.05;
    private static final double REST_METRES_PER_SECOND = 0.02;

    private Translation2d position = Translation2d.ORIGIN;
    private Translation2d velocity = Translation2d.ORIGIN;
    private double positionVariance = Double.POSITIVE_INFINITY;
    private double covariance;
    private double speedVariance;

    /** Creates a filter that knows nothing. */
    public BallFilter() {}

    /** Forgets everything. */
    public void reset() {
        positionVariance = Double.POSITIVE_INFINITY;
        velocity = Translation2d.ORIGIN;
    }

    /** {@return whether the ball was ever seen} */
    public boolean isKnown() {
        return Double.isFinite(positionVariance);
    }

    /**
     * Lets the ball roll on.
     *
     * @param seconds how long
     */
    public void roll(double seconds) {
        double slower = PortableMath.exp(-seconds / ROLLING_SECONDS);
        double reach = ROLLING_SECONDS * (1 - slower);
        position = position.plus(velocity.times(reach));
        velocity = velocity.times(slower);
        positionVariance += 2 * reach * covariance + reach * reach * speedVariance + POSITION_NOISE * seconds;
        covariance = slower * (covariance + reach * speedVariance);
        speedVariance = slower * slower * speedVariance + SPEED_NOISE * seconds;
    }

    /**
     * Takes in a picture of the ball.
     *
     * @param seen where the camera sees it
     * @param deviation the usual error of such a picture in metres, above 0
     */
    public void see(Translation2d seen, double deviation) {
        double noise = deviation * deviation;
        if (!isKnown()) {
            begin(seen, noise);
            return;
        }
        Translation2d miss = seen.minus(position);
        if (miss.dot(miss) > SURPRISE * (positionVariance + noise)) {
            speedVariance = KICKED_VARIANCE;
            positionVariance += FIRST_VARIANCE;
            covariance = 0;
        }
        double sum = positionVariance + noise;
        position = position.plus(miss.times(positionVariance / sum));
        velocity = velocity.plus(miss.times(covariance / sum));
        speedVariance -= covariance * covariance / sum;
        covariance *= noise / sum;
        positionVariance *= noise / sum;
    }

    private void begin(Translation2d seen, double noise) {
        position = seen;
        velocity = Translation2d.ORIGIN;
        positionVariance = noise;
        covariance = 0;
        speedVariance = KICKED_VARIANCE;
    }

    /** {@return where the ball is now} */
    public Translation2d position() {
        return position;
    }

    /** {@return how it rolls, metres per second} */
    public Translation2d velocity() {
        return velocity.length() < REST_METRES_PER_SECOND ? Translation2d.ORIGIN : velocity;
    }

    /** {@return how far from the truth the position usually is, metres; infinite if the ball was never seen} */
    public double deviation() {
        return Math.sqrt(positionVariance);
    }

    /**
     * Foresees where the ball will be.
     *
     * @param position where it is now
     * @param velocity how it rolls now, metres per second
     * @param seconds how much later
     * @return its place then
     */
    public static Translation2d foresee(Translation2d position, Translation2d velocity, double seconds) {
        return position.plus(
                velocity.times(ROLLING_SECONDS * (1 - PortableMath.exp(-Math.max(0, seconds) / ROLLING_SECONDS))));
    }
}
