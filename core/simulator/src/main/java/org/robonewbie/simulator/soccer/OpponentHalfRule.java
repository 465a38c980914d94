package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.physics.BoundingBox;

/** Keeps robots in their own halves before and during a kick-off, unless they may start anywhere. */
final class OpponentHalfRule {

    private static final double RUN_OFF = 10;

    private final Match match;
    private final double moveDistance;
    private final double circleRadius;
    private final boolean switchedOff;

    OpponentHalfRule(Match match) {
        this.match = match;
        SoccerParameters parameters = match.parameters();
        moveDistance = parameters.get(SoccerParameter.FREE_KICK_MOVE_DISTANCE);
        circleRadius = parameters.get(SoccerParameter.FREE_KICK_DISTANCE);
        switchedOff = parameters.isOn(SoccerParameter.START_ANY_FIELD_POSITION);
    }

    void keepInOwnHalf(TeamSide side) {
        if (!switchedOff) {
            match.repositioning().clearArea(side, half(side.opponent()), moveDistance);
        }
    }

    /** Enforces positions at a kick-off: only robots of the kicking team may stand in the centre circle. */
    void clearForKickOff(TeamSide kicking) {
        if (switchedOff) {
            return;
        }
        TeamSide opponents = kicking.opponent();
        keepInOwnHalf(opponents);
        match.repositioning().clearCircle(opponents, match.centreSpot(), circleRadius, moveDistance);
        Area opponentHalf = half(opponents);
        double x = kicking == TeamSide.LEFT ? -moveDistance : moveDistance;
        for (Player player : match.players(kicking)) {
            BoundingBox box = player.robot().boundingBox();
            if (opponentHalf.touches(box) && !isInCircle(box)) {
                Vector3 position = player.position();
                match.repositioning().move(player, new Vector3(x, position.y(), position.z()));
            }
        }
    }

    private boolean isInCircle(BoundingBox box) {
        double x = Math.max(Math.abs(box.min().x()), Math.abs(box.max().x()));
        double y = Math.max(Math.abs(box.min().y()), Math.abs(box.max().y()));
        return PortableMath.hypot(x, y) <= circleRadius;
    }

    private Area half(TeamSide side) {
        double halfLength = match.field().length() / 2 + RUN_OFF;
        double halfWidth = match.field().width() / 2 + RUN_OFF;
        return side == TeamSide.LEFT
                ? new Area(-halfLength, 0, -halfWidth, halfWidth)
                : new Area(0, halfLength, -halfWidth, halfWidth);
    }
}
