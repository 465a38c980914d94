package org.robonewbie.simulator.world;

/**
 * Size and weight of a ball.
 *
 * @param radius in metres
 * @param massKg in kilograms
 */
public record BallProperties(double radius, double massKg) {

    /** The ball of rcssserver3d 0.7.3. */
    public static final BallProperties STANDARD = new BallProperties(0.042, 0.026);
}
