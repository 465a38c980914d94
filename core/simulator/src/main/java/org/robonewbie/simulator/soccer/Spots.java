package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;

/** Ball positions for set pieces, in the world frame in metres, and waiting positions beside the pitch. */
final class Spots {

    private static final double SPACING_BESIDE_PITCH = 0.6;
    private static final int NUMBER_AT_HALFWAY_LINE = 7;
    private static final double DISTANCE_BESIDE_PITCH = 0.5;

    private Spots() {}

    static Vector3 kickIn(Match match) {
        Vector3 out = match.ball().lastValidPosition();
        return at(match, out.x(), Math.copySign(sideLine(match), out.y()));
    }

    /** Returns the spot for a corner kick, halfway between the goal post and the corner flag. */
    static Vector3 corner(Match match, TeamSide attackers) {
        SoccerField field = match.field();
        double x = field.length() / 2 - match.ball().radius();
        double y = (field.width() + field.goalWidth()) / 4 - match.ball().radius();
        double sign = attackers == TeamSide.LEFT ? 1 : -1;
        return at(
                match,
                sign * x,
                Math.copySign(y, match.ball().lastValidPosition().y()));
    }

    static Vector3 goalKick(Match match, TeamSide side) {
        double x = match.field().length() / 2 - match.parameters().get(SoccerParameter.GOAL_KICK_DISTANCE);
        return at(match, side == TeamSide.LEFT ? -x : x, 0);
    }

    static Vector3 freeKick(Match match) {
        return outOfPenaltyAreas(match, match.ball().lastValidPosition());
    }

    static Vector3 dropBall(Match match, Vector3 position) {
        Vector3 spot = outOfPenaltyAreas(match, position);
        double limit = sideLine(match);
        return at(match, spot.x(), Math.max(-limit, Math.min(limit, spot.y())));
    }

    /**
     * Returns the waiting position of a player beside the pitch, on the side away from the ball; each uniform number
     * has its own position.
     */
    static Vector3 besidePitch(Match match, Player player) {
        double x = SPACING_BESIDE_PITCH * (NUMBER_AT_HALFWAY_LINE - player.number());
        double y = match.field().width() / 2 + DISTANCE_BESIDE_PITCH;
        return new Vector3(
                player.side() == TeamSide.LEFT ? -x : x, match.ball().position().y() < 0 ? y : -y, 0);
    }

    /** Moves a position inside a penalty area to the nearer front corner of the area. */
    private static Vector3 outOfPenaltyAreas(Match match, Vector3 position) {
        for (TeamSide side : TeamSide.values()) {
            Area area = match.penaltyArea(side);
            if (area.contains(position)) {
                double x = side == TeamSide.LEFT ? area.maxX() : area.minX();
                return at(match, x, position.y() < 0 ? area.minY() : area.maxY());
            }
        }
        return at(match, position.x(), position.y());
    }

    private static double sideLine(Match match) {
        return match.field().width() / 2 - match.ball().radius();
    }

    private static Vector3 at(Match match, double x, double y) {
        return new Vector3(x, y, match.ball().radius());
    }
}
