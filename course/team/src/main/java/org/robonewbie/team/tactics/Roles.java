package org.robonewbie.team.tactics;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.Goalkeeping;
import org.robonewbie.team.talk.TeamMessage;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.Mate;
import org.robonewbie.team.world.WorldModel;

/**
 * Assigns roles to players. All players compute the same assignment from their messages, so they agree without a captain.
 *
 * <p>The player with the shortest time to the ball is the striker. The others share the positions of the {@link Formation} at
 * minimum total cost. Hysteresis keeps roles stable: a new striker must be faster by {@link #STRIKER_LEAD_SECONDS}, and the
 * position of the current role costs {@link #ROLE_LEAD_METRES} less.
 */
public final class Roles {

    static final double STRIKER_LEAD_SECONDS = 0.8;
    static final double ROLE_LEAD_METRES = 1;

    private static final int KEEPER_NUMBER = 1;
    private static final double SILENT_SECONDS = 2;

    private final WorldModel world;
    private final TeamRole before;
    private final double secondsToBall;

    private record Candidate(int number, Translation2d place, TeamRole role) {}

    /**
     * Creates the assignment; the role is computed on demand.
     *
     * @param world the world model
     * @param before the player's current role
     * @param secondsToBall seconds until the player could play the ball
     */
    public Roles(WorldModel world, TeamRole before, double secondsToBall) {
        this.world = world;
        this.before = before;
        this.secondsToBall = secondsToBall;
    }

    /** {@return the player's role} */
    public TeamRole own() {
        boolean keeper = isKeeper(world, world.number());
        boolean leavesGoal = !keeper || !world.mates().isEmpty() || Goalkeeping.mayClear(world);
        if (leavesGoal && isStriker()) {
            return TeamRole.STRIKER;
        }
        return keeper ? TeamRole.KEEPER : placeInFormation();
    }

    /**
     * Returns whether a player is the keeper. A team of fewer than eight has no keeper, because every player is needed near the
     * ball. An exception is the penalty shoot-out, in which player number 1 starts alone in its goal and is the keeper.
     *
     * @param world the world model
     * @param number player number
     * @return whether the player is the keeper
     */
    public static boolean isKeeper(WorldModel world, int number) {
        boolean alone = world.mates().isEmpty() && world.hasBegunInGoal();
        return number == KEEPER_NUMBER && (alone || !world.isSmallTeam());
    }

    /**
     * Returns whether the player is a keeper without teammates, as in a penalty shoot-out.
     *
     * @param world the world model
     * @return whether the player is such a keeper
     */
    public static boolean keepsAlone(WorldModel world) {
        return world.mates().isEmpty() && isKeeper(world, world.number());
    }

    private boolean isStriker() {
        double own = secondsToBall - (before == TeamRole.STRIKER ? STRIKER_LEAD_SECONDS : 0);
        return world.mates().stream()
                .filter(mate -> world.seconds() - mate.heardSeconds() < SILENT_SECONDS)
                .allMatch(mate -> own < claim(mate) || (own == claim(mate) && world.number() < mate.number()));
    }

    private static double claim(Mate mate) {
        TeamMessage message = mate.message();
        return message.secondsToBall() - (message.role() == TeamRole.STRIKER ? STRIKER_LEAD_SECONDS : 0);
    }

    private TeamRole placeInFormation() {
        List<Candidate> players = players();
        Map<TeamRole, Translation2d> places = new Formation(world.field()).places(world.ball(), players.size());
        List<TeamRole> roles = List.copyOf(places.keySet());
        double[][] cost = new double[players.size()][roles.size()];
        int own = 0;
        for (int i = 0; i < players.size(); i++) {
            own = players.get(i).number == world.number() ? i : own;
            for (int j = 0; j < roles.size(); j++) {
                Translation2d place = places.getOrDefault(roles.get(j), Translation2d.ORIGIN);
                cost[i][j] = cost(players.get(i), roles.get(j), place);
            }
        }
        return roles.get(Assignment.cheapest(cost)[own]);
    }

    private static double cost(Candidate player, TeamRole role, Translation2d place) {
        double metres = player.place.distanceTo(place) - (player.role == role ? ROLE_LEAD_METRES : 0);
        return Math.max(0, metres) * Math.max(0, metres);
    }

    /** Returns all players except the keeper and the striker, sorted by number. */
    private List<Candidate> players() {
        int striker = striker();
        List<Candidate> players = new ArrayList<>();
        for (Mate mate : world.mates()) {
            if (!isKeeper(world, mate.number()) && mate.number() != striker) {
                players.add(new Candidate(
                        mate.number(), mate.place(), mate.message().role()));
            }
        }
        players.add(new Candidate(world.number(), world.place(), before));
        players.sort((one, other) -> Integer.compare(one.number, other.number));
        return players.subList(0, Math.min(players.size(), 9));
    }

    private int striker() {
        return world.mates().stream()
                .min(Comparator.comparingDouble(Roles::claim))
                .map(Mate::number)
                .orElse(0);
    }
}
