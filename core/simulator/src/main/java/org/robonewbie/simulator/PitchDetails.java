package org.robonewbie.simulator;

/**
 * What differs between the pitches of servers, besides the dimensions in {@link org.robonewbie.nao.SoccerField}.
 *
 * @param ballRadius radius of the ball in metres
 * @param goalAreaLength depth of the goal area inside the penalty area in metres; 0 for none
 * @param goalAreaWidth width of the goal area in metres; 0 for none
 * @param penaltySpotDistance distance of the penalty spot from the goal line in metres; 0 for none
 */
public record PitchDetails(double ballRadius, double goalAreaLength, double goalAreaWidth, double penaltySpotDistance) {

    /** SimSpark's pitch: the small ball, and neither goal area nor penalty spot. */
    public static final PitchDetails SIMSPARK = new PitchDetails(0.042, 0, 0, 0);
}
