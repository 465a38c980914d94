package org.robonewbie.team.tactics;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.team.world.WorldModel;

/**
 * Kick-off positions by player number. Players with low numbers, starting with 2, get the positions closest to the ball, so
 * that small teams attack too. All positions are in the team's own half. Number 2 kicks off; it stands ready to kick to the
 * left, where number 3 waits for the ball.
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
    private static final Pose2d KICK = new Pose2d(-0.3, -0.4, 75);
    private static final Pose2d RECEIVE = new Pose2d(-0.9, 5, -60);
    private static final double BESIDE_METRES = 1.4;
    private static final double BEHIND_CIRCLE_METRES = 0.4;

    private static final Pose2d PUSH = new Pose2d(-1, 0, 0);

    private KickOffPositions() {}

    /**
     * Returns the position of a player.
     *
     * @param world its world model
     * @param kicksOff whether its team takes the kick-off
     * @return the pose in team coordinates
     */
    public static Pose2d place(WorldModel world, boolean kicksOff) {
        return kicksOff && world.number() == KICKER && !world.abilities().movesLegs()
                ? PUSH
                : place(world.number(), kicksOff, !Roles.isKeeper(world, 1), world.field());
    }

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
            return kicksOff ? KICK : new Pose2d(behindCircle, 0.06, 0);
        }
        if (number == KICKER + 1) {
            double y = Math.min(RECEIVE.y(), field.width() / 2 - 1);
            return kicksOff ? new Pose2d(RECEIVE.x(), y, RECEIVE.degrees()) : new Pose2d(2 * behindCircle, 0, 0);
        }
        if (number == 1 && small) {
            return new Pose2d(1.5 * behindCircle, -BESIDE_METRES, 0);
        }
        double scale = field.length() / SoccerField.LEAGUE.length();
        double[] place = LEAGUE[Math.max(1, Math.min(LEAGUE.length, number)) - 1];
        return new Pose2d(place[0] * scale, place[1] * scale, 0);
    }
}
