package org.robonewbie.nao;

/**
 * The dimensions of a pitch in metres and the positions of its landmarks in the world frame.
 *
 * <p>World frame: origin at the centre spot, x from the left goal to the right goal, y to the left of that direction, z up.
 * Source: SimSpark's {@code soccer.rsg} and {@code goal.rsg}.
 *
 * @param length distance between the goal lines
 * @param width distance between the side lines
 * @param goalWidth distance between the posts
 * @param goalDepth distance from the goal line to the back of the goal
 * @param goalHeight height of the posts
 * @param penaltyLength depth of the penalty area
 * @param penaltyWidth width of the penalty area in excess of the goal's width
 * @param centreCircleRadius radius of the centre circle, also the distance that opponents keep from a free kick
 */
public record SoccerField(
        double length,
        double width,
        double goalWidth,
        double goalDepth,
        double goalHeight,
        double penaltyLength,
        double penaltyWidth,
        double centreCircleRadius) {

    /** Radius of the ball, metres. */
    public static final double BALL_RADIUS = 0.042;

    /** The league's pitch, 30 m × 20 m. */
    public static final SoccerField LEAGUE = new SoccerField(30, 20, 2.1, 0.6, 0.8, 1.8, 3.9, 2.0);

    /** The pitch of today's league, for teams of seven on RCSSServerMJ, 55 m × 36 m. */
    public static final SoccerField SEVEN = new SoccerField(55, 36, 3.66, 1, 1.83, 9, 12.84, 5.5);

    /** The small pitch for beginners, 12 m × 8 m. */
    public static final SoccerField BEGINNER = new SoccerField(12, 8, 1.4, 0.4, 0.8, 1.2, 2.6, 1.3);

    /**
     * Returns the position of a landmark.
     *
     * @param landmark a goal post or corner flag
     * @return its position in the world frame, in metres
     */
    public Vector3 position(Landmark landmark) {
        double x = landmark.side() == TeamSide.LEFT ? -length / 2 : length / 2;
        return switch (landmark) {
            case GOAL_POST_1_LEFT, GOAL_POST_1_RIGHT -> new Vector3(x, goalWidth / 2, goalHeight);
            case GOAL_POST_2_LEFT, GOAL_POST_2_RIGHT -> new Vector3(x, -goalWidth / 2, goalHeight);
            case FLAG_1_LEFT, FLAG_1_RIGHT -> new Vector3(x, width / 2, 0);
            case FLAG_2_LEFT, FLAG_2_RIGHT -> new Vector3(x, -width / 2, 0);
        };
    }
}
