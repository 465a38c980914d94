package org.robonewbie.team.tactics;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * Kick-off positions by player number. Players with low numbers, starting with 2, get the positions closest to the ball, so
 * that small teams attack too. All positions are in the team's own half. Only the kicker and the player that plays the ball
 * next may be inside the centre circle.
 */
public final class KickOffPositions {

    private static final double[][] LEAGUE = {
        {-14.5, 0},
        {-0.45, 0.06},
        {-2.5, 0},
        {-1.2, 3.5},
        {-1.2, -3.5},
        {-5, 0},
        {-5, 3.5},
        {-5, -3.5},
        {-1.2, 7},
        {-1.2, -7},
        {-9, 0}
    };
    private static final int KICKER = 2;
    private static final double KICK_METRES = -0.45;
    private static final double NEXT_METRES = 1.4;
    private static final double BEHIND_CIRCLE_METRES = 0.4;

    private KickOffPositions() {}

    /**
     * Returns the position of a player.
     *
     * @param number player number, 1 to 11
     * @param kicksOff whether this team takes the kick-off
     * @param small whether the team is too small for a keeper
     * @param field the field
     * @return the pose in team coordinates
     */
    public static Pose2d place(int number, boolean kicksOff, boolean small, SoccerField field) {
        double behindCircle = -field.centreCircleRadius() - BEHIND_CIRCLE_METRES;
        if (number == KICKER) {
            return new Pose2d(kicksOff ? KICK_METRES : behindCircle, 0.06, 0);
        }
        if (number == KICKER + 1) {
            return kicksOff ? new Pose2d(KICK_METRES, NEXT_METRES, 0) : new Pose2d(2 * behindCircle, 0, 0);
        }
        if (number == 1 && small) {
            return new Pose2d(1.5 * behindCircle, -NEXT_METRES, 0);
        }
        double scale = field.length() / SoccerField.LEAGUE.length();
        double[] place = LEAGUE[Math.max(1, Math.min(LEAGUE.length, number)) - 1];
        return new Pose2d(place[0] * scale, place[1] * scale, 0);
    }
}
