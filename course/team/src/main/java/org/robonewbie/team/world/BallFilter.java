package org.robonewbie.team.world;

import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.math.PortableMath;

/**
 * Kalman filter for the position and velocity of the ball.
 *
 * <p>Model: the grass decelerates the ball in proportion to its speed, v(t) = v₀ e<sup>−t/τ</sup>, so it travels v₀ τ
 * (1 − e<sup>−t/τ</sup>) in time t, and v₀ τ in total, where v₀ is its initial speed and τ = 0.677 s. This model is
 * linear, as the filter requires.
 *
 * <p>Filter: {@link #roll} predicts the motion of the ball, which increases the uncertainty. {@link #see} corrects the
 * estimate with a sighting; the less certain the estimate, the greater the weight of the sighting. A sighting that
 * contradicts the estimate indicates a kick, after which the velocity is unknown until the next image.
 *
 * <p>Both axes have the same uncertainty, so three numbers replace the matrix: the variances of position and velocity, and
 * their covariance.
 *
 * <p>Source: R. E. Kalman, <em>A new approach to linear filtering and prediction problems</em>, 1960.
 */
public final class BallFilter {

    /** Time constant τ: before it stops, the ball travels this many metres for each metre per second of its speed. */
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

    /** Creates a filter without an estimate. */
    public BallFilter() {}

    /** Clears the estimate. */
    public void reset() {
        positionVariance = Double.POSITIVE_INFINITY;
        velocity = Translation2d.ORIGIN;
    }

    /** {@return whether the ball has ever been seen} */
    public boolean isKnown() {
        return Double.isFinite(positionVariance);
    }

    /**
     * Advances the estimate by a time step.
     *
     * @param seconds elapsed time
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
     * Corrects the estimate with a sighting.
     *
     * @param seen measured position
     * @param deviation standard deviation of the measurement in metres, above 0
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

    /** {@return the position of the ball} */
    public Translation2d position() {
        return position;
    }

    /** {@return the velocity of the ball in metres per second} */
    public Translation2d velocity() {
        return velocity.length() < REST_METRES_PER_SECOND ? Translation2d.ORIGIN : velocity;
    }

    /** {@return the standard deviation of the position in metres; infinite if the ball has never been seen} */
    public double deviation() {
        return Math.sqrt(positionVariance);
    }

    /**
     * Predicts where the ball will be, assuming that it slows down exponentially.
     *
     * @param position current position
     * @param velocity current velocity in metres per second
     * @param seconds how far to predict, in seconds
     * @return the predicted position
     */
    public static Translation2d predict(Translation2d position, Translation2d velocity, double seconds) {
        return position.plus(
                velocity.times(ROLLING_SECONDS * (1 - PortableMath.exp(-Math.max(0, seconds) / ROLLING_SECONDS))));
    }
}
