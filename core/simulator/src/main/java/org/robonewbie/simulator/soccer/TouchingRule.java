package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.FoulType;
import org.robonewbie.simulator.world.RobotContact;

/** Touching foul: limits the size of a group of robots in contact and removes an offender from the group. */
final class TouchingRule implements FoulRule {

    private final Match match;

    TouchingRule(Match match) {
        this.match = match;
    }

    @Override
    public void judge() {
        List<Set<Player>> groups = groups();
        for (Set<Player> group : groups) {
            if (group.size() > match.parameters().get(SoccerParameter.MAX_TOUCH_GROUP_SIZE)) {
                newcomer(group).flatMap(player -> offender(player, group)).ifPresent(player -> punish(player, group));
            }
        }
        match.players().forEach(player -> player.fouls().setTouched(Set.of()));
        groups.forEach(group -> group.forEach(player -> player.fouls().setTouched(group)));
    }

    /** Returns the groups of players that are in contact, directly or through others, in the order of the contacts. */
    private List<Set<Player>> groups() {
        List<Set<Player>> groups = new ArrayList<>();
        for (RobotContact contact : match.robotContacts()) {
            Optional<Player> first = match.playerOf(contact.first().robot());
            Optional<Player> second = match.playerOf(contact.second().robot());
            if (first.isPresent() && second.isPresent() && !isBetweenFeet(contact)) {
                join(groups, first.get(), second.get());
            }
        }
        return groups;
    }

    /** Merges the groups of two players; the merged group becomes the last one. */
    private static void join(List<Set<Player>> groups, Player first, Player second) {
        for (int i = groups.size() - 1; i >= 0; i--) {
            if (groups.get(i).contains(first) && groups.get(i).contains(second)) {
                groups.add(groups.remove(i));
                return;
            }
        }
        Set<Player> joined = new LinkedHashSet<>();
        for (Set<Player> group : groups) {
            if (group.contains(first) || group.contains(second)) {
                joined.addAll(group);
            }
        }
        groups.removeIf(joined::containsAll);
        joined.add(first);
        joined.add(second);
        groups.add(joined);
    }

    /** Returns whether a contact is between feet or toes; as in rcssserver3d, such contacts do not count. */
    private static boolean isBetweenFeet(RobotContact contact) {
        return isFoot(contact.first().name()) && isFoot(contact.second().name());
    }

    private static boolean isFoot(String link) {
        return link.endsWith("foot") || link.endsWith("toe");
    }

    private static Optional<Player> newcomer(Set<Player> group) {
        return group.stream()
                .filter(player -> !player.fouls().isPunished())
                .filter(player -> group.stream()
                        .noneMatch(other ->
                                other != player && player.fouls().touched().contains(other)))
                .findFirst();
    }

    /**
     * Returns the offender: the newcomer if its team makes up at least half of the group, otherwise an opponent of the
     * newcomer; never a goalkeeper.
     */
    private static Optional<Player> offender(Player newcomer, Set<Player> group) {
        TeamSide side = newcomer.side();
        long mates = group.stream().filter(player -> player.side() == side).count();
        TeamSide guilty = 2 * mates >= group.size() ? side : side.opponent();
        if (guilty == side && !newcomer.isGoalkeeper()) {
            return Optional.of(newcomer);
        }
        return group.stream()
                .filter(player -> player.side() == guilty && !player.isGoalkeeper())
                .filter(player -> !player.fouls().isPunished())
                .findFirst();
    }

    private void punish(Player player, Set<Player> group) {
        if (match.parameters().isOn(SoccerParameter.TOUCHING_FOUL_BEAM_PENALTY)) {
            match.referee().punish(player, FoulType.TOUCHING);
            return;
        }
        Vector3 centre = Vector3.ZERO;
        for (Player member : group) {
            centre = centre.plus(member.position().times(1.0 / group.size()));
        }
        match.referee().report(player, FoulType.TOUCHING);
        match.repositioning().moveAway(player, centre, match.parameters().get(SoccerParameter.AGENT_RADIUS));
    }
}
