package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.FoulType;

/** Illegal defence foul: limits the number of a team's robots in its own penalty area. */
final class IllegalDefenceRule implements FoulRule {

    private final Match match;

    IllegalDefenceRule(Match match) {
        this.match = match;
    }

    @Override
    public void judge() {
        match.referee().sides().forEach(this::judge);
    }

    private void judge(TeamSide side) {
        Area area = match.penaltyArea(side);
        List<Player> inside = new ArrayList<>(0);
        for (Player player : match.players(side)) {
            player.fouls().updateArea(area.contains(player.position()), match.currentTick());
            if (player.fouls().areaEntryTick() != FoulHistory.NEVER
                    && !player.fouls().isPunished()) {
                inside.add(player);
            }
        }
        if (inside.size() > match.parameters().get(SoccerParameter.MAX_PLAYERS_INSIDE_OWN_AREA)) {
            offender(inside, side).ifPresent(player -> punish(player, area));
        }
    }

    /**
     * Returns the offender: the field player that entered the area last or, if the goalkeeper entered last, the field
     * player farthest from the goal.
     */
    private Optional<Player> offender(List<Player> inside, TeamSide side) {
        Optional<Player> last = inside.stream()
                .max(Comparator.comparingLong(player -> player.fouls().areaEntryTick()));
        if (last.isPresent() && !last.get().isGoalkeeper()) {
            return last;
        }
        double goalX = side == TeamSide.LEFT
                ? -match.field().length() / 2
                : match.field().length() / 2;
        Vector3 goal = new Vector3(goalX, 0, 0);
        return inside.stream()
                .filter(player -> !player.isGoalkeeper())
                .max(Comparator.comparingDouble(player -> Referee.flatDistance(player, goal)));
    }

    private void punish(Player player, Area area) {
        if (match.parameters().isOn(SoccerParameter.ILLEGAL_DEFENSE_BEAM_PENALTY)) {
            match.referee().punish(player, FoulType.ILLEGAL_DEFENCE);
        } else {
            match.referee().report(player, FoulType.ILLEGAL_DEFENCE);
            match.repositioning().move(player, nearestPositionOutside(player, area));
        }
    }

    private Vector3 nearestPositionOutside(Player player, Area area) {
        double room = match.parameters().get(SoccerParameter.AGENT_RADIUS);
        Vector3 position = player.position();
        double front = player.side() == TeamSide.LEFT ? area.maxX() + room : area.minX() - room;
        double side = position.y() < 0 ? area.minY() - room : area.maxY() + room;
        boolean frontIsNearer = Math.abs(front - position.x()) <= Math.abs(side - position.y());
        return frontIsNearer
                ? new Vector3(front, position.y(), position.z())
                : new Vector3(position.x(), side, position.z());
    }
}
