package org.robonewbie.simulator.world;

import org.robonewbie.nao.SoccerField;

/**
 * Radius and mass of a ball.
 *
 * @param radius radius in metres
 * @param massKg mass in kilograms
 */
public record BallProperties(double radius, double massKg) {

    /** The ball of rcssserver3d 0.7.3. */
    public static final BallProperties STANDARD = new BallProperties(SoccerField.BALL_RADIUS, 0.026);
}
