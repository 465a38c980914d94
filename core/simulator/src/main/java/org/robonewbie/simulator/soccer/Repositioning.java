package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.physics.BoundingBox;

/** Moves robots to free positions on behalf of the referee (SimSpark: {@code soccerruleaspect.cpp}). */
final class Repositioning {

    private static final int COLUMNS = 10;
    private static final int ROWS = 11;

    private final Match match;
    private final SoccerField field;
    private final double agentRadius;

    Repositioning(Match match) {
        this.match = match;
        this.field = match.field();
        this.agentRadius = match.parameters().get(SoccerParameter.AGENT_RADIUS);
    }

    /** Moves a team's robots out of a circle. */
    void clearCircle(TeamSide side, Vector3 centre, double radius, double moveDistance) {
        for (Player player : match.players(side)) {
            if (player.isWithin(radius, centre)) {
                move(player, besideCircle(player, centre, moveDistance));
            }
        }
    }

    /** Moves a team's robots out of a rectangle, towards their own goal. */
    void clearArea(TeamSide side, Area area, double moveDistance) {
        double x = side == TeamSide.LEFT ? area.minX() - moveDistance : area.maxX() + moveDistance;
        for (Player player : match.players(side)) {
            if (area.touches(player.robot().boundingBox())) {
                Vector3 position = player.position();
                move(player, new Vector3(x, position.y(), position.z()));
            }
        }
    }

    /** Moves a team's robots radially away from a point if they are too close to it. */
    void pushAway(TeamSide side, Vector3 centre, double within, double distance) {
        for (Player player : match.players(side)) {
            Vector3 position = player.position();
            double x = position.x() - centre.x();
            double y = position.y() - centre.y();
            double length = PortableMath.hypot(x, y);
            if (length < within) {
                double factor = length == 0 ? 0 : distance / length;
                double pushedX = length == 0 ? centre.x() + ownDirection(side) * distance : centre.x() + factor * x;
                Vector3 wanted = new Vector3(pushedX, centre.y() + factor * y, position.z());
                place(player, search(player, wanted, target -> isFree(player, target)));
            }
        }
    }

    /** Moves a robot to a position or, if that is occupied, to a free one nearby. */
    void move(Player player, Vector3 wanted) {
        place(player, search(player, wanted, target -> isFree(player, target) && !isAtBall(target)));
    }

    /** Moves a robot radially away from a point, or to a free position nearby. */
    void moveAway(Player player, Vector3 centre, double distance) {
        Vector3 position = player.position();
        double x = position.x() - centre.x();
        double y = position.y() - centre.y();
        double length = PortableMath.hypot(x, y);
        Vector3 offset = length == 0
                ? new Vector3(ownDirection(player.side()) * distance, 0, 0)
                : new Vector3(x / length * distance, y / length * distance, 0);
        move(player, position.plus(offset));
    }

    private void place(Player player, Vector3 position) {
        player.robot().moveTo(position);
        player.fouls().moved(match.currentTick());
    }

    private Vector3 besideCircle(Player player, Vector3 centre, double moveDistance) {
        Vector3 position = player.position();
        double x = centre.x() + ownDirection(player.side()) * moveDistance;
        if (ownDirection(player.side()) * x <= field.length() / 2) {
            return new Vector3(x, position.y(), position.z());
        }
        double y = centre.y() < 0 ? centre.y() + moveDistance : centre.y() - moveDistance;
        return new Vector3(position.x(), y, position.z());
    }

    private Vector3 search(Player player, Vector3 wanted, Predicate<Vector3> allowed) {
        int attempts = (int) match.parameters().get(SoccerParameter.MAX_NUM_SAFE_REPOSITION_ATTEMPTS);
        if (attempts == 0 || allowed.test(wanted)) {
            return wanted;
        }
        return candidates(player, wanted).stream()
                .limit(attempts)
                .filter(allowed)
                .findFirst()
                .orElse(wanted);
    }

    private List<Vector3> candidates(Player player, Vector3 wanted) {
        List<Vector3> positions = new ArrayList<>();
        for (int column = 0; column < COLUMNS; column++) {
            for (int row = -ROWS / 2; row <= ROWS / 2; row++) {
                positions.add(wanted.plus(
                        new Vector3(ownDirection(player.side()) * column * agentRadius, row * agentRadius, 0)));
            }
        }
        Vector3 present = player.position();
        positions.sort(Comparator.comparingDouble(present::distanceTo));
        return positions;
    }

    private boolean isFree(Player player, Vector3 target) {
        return !isAtGoal(target)
                && match.players().stream().noneMatch(other -> other != player && isTooNear(other, target))
                && !isFullArea(player, target);
    }

    private boolean isTooNear(Player other, Vector3 target) {
        BoundingBox box = other.robot().boundingBox();
        return target.x() > box.min().x() - agentRadius
                && target.x() < box.max().x() + agentRadius
                && target.y() > box.min().y() - agentRadius
                && target.y() < box.max().y() + agentRadius;
    }

    private boolean isAtBall(Vector3 target) {
        double distance =
                Math.max(2 * agentRadius, match.parameters().get(SoccerParameter.PASS_MODE_MIN_OPPONENT_BALL_DISTANCE));
        Vector3 ball = match.ball().position();
        return PortableMath.hypot(target.x() - ball.x(), target.y() - ball.y()) < distance;
    }

    private boolean isAtGoal(Vector3 target) {
        return Math.abs(target.x()) > field.length() / 2 && Math.abs(target.y()) < field.goalWidth() / 2 + agentRadius;
    }

    private boolean isFullArea(Player player, Vector3 target) {
        Area area = match.penaltyArea(player.side());
        if (!area.contains(target)) {
            return false;
        }
        long inside = match.players(player.side()).stream()
                .filter(mate -> mate != player && area.contains(mate.position()))
                .count();
        return inside >= (int) match.parameters().get(SoccerParameter.MAX_PLAYERS_INSIDE_OWN_AREA);
    }

    private static double ownDirection(TeamSide side) {
        return side == TeamSide.LEFT ? -1 : 1;
    }
}
