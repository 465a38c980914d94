package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.world.Robot;

/**
 * The two teams of a match (SimSpark: {@code gamestateaspect.cpp}). The first team to join plays on the left, the
 * second on the right. Both names stay reserved when the players leave, until the match is reset.
 */
public final class Teams {

    private final SoccerParameters parameters;
    private final List<Team> teams = new ArrayList<>();
    private final List<Player> players = new ArrayList<>();
    private final List<Player> readOnly = Collections.unmodifiableList(players);
    private final StartPositions leftPositions;
    private final StartPositions rightPositions;

    Teams(SoccerParameters parameters) {
        this.parameters = parameters;
        leftPositions = new StartPositions(TeamSide.LEFT, parameters);
        rightPositions = new StartPositions(TeamSide.RIGHT, parameters);
    }

    /** {@return all players of both teams in the order in which they joined, unmodifiable} */
    public List<Player> players() {
        return readOnly;
    }

    /**
     * Returns the team on a side.
     *
     * @param side half that the team defends
     * @return the team; empty before its first player joins
     */
    public Optional<Team> team(TeamSide side) {
        for (int i = 0; i < teams.size(); i++) {
            if (teams.get(i).side() == side) {
                return Optional.of(teams.get(i));
            }
        }
        return Optional.empty();
    }

    /**
     * Returns a team's name.
     *
     * @param side half that the team defends
     * @return the name; empty before its first player joins
     */
    public String name(TeamSide side) {
        return team(side).map(Team::name).orElse("");
    }

    /**
     * Finds a player.
     *
     * @param side half that the team defends
     * @param number shirt number
     * @return the player, if there is one
     */
    public Optional<Player> player(TeamSide side, int number) {
        return players.stream()
                .filter(player -> player.side() == side && player.number() == number)
                .findFirst();
    }

    /** Finds the player to which a robot belongs. */
    Optional<Player> playerOf(Robot robot) {
        for (int i = 0; i < players.size(); i++) {
            if (players.get(i).robot() == robot) {
                return Optional.of(players.get(i));
            }
        }
        return Optional.empty();
    }

    /**
     * Adds a robot to a team and moves it to its start position next to the side line.
     *
     * @param name team name
     * @param number requested number; 0 for the lowest free one
     * @param robot the robot
     * @return the new player
     * @throws JoinRefusedException if the team, number or robot type is not allowed
     */
    public Player join(String name, int number, Robot robot) throws JoinRefusedException {
        Team team = findOrCreate(name);
        Optional<String> objection = team.objection(number, robot.type());
        if (objection.isPresent()) {
            throw new JoinRefusedException(objection.get());
        }
        Player player = team.add(number, robot);
        players.add(player);
        putToStart(player);
        return player;
    }

    /**
     * Removes a player from its team and frees its number.
     *
     * @param player the player
     */
    public void leave(Player player) {
        players.remove(player);
        player.team().remove(player);
    }

    /**
     * Moves a player to the next start position of its team.
     *
     * @param player the player
     */
    public void putToStart(Player player) {
        boolean left = player.side() == TeamSide.LEFT;
        player.robot().moveUpright((left ? leftPositions : rightPositions).next(), left ? -90 : 90);
    }

    /** Frees the names of teams without players. */
    void removeEmpty() {
        teams.removeIf(team -> team.players().isEmpty());
    }

    Player replaceRobot(Player old, Robot robot) {
        Player replacement = new Player(old.team(), old.number(), robot);
        old.team().replace(old, replacement);
        players.set(players.indexOf(old), replacement);
        return replacement;
    }

    void changeSides() {
        teams.forEach(Team::changeSide);
    }

    private Team findOrCreate(String name) throws JoinRefusedException {
        for (Team team : teams) {
            if (team.name().equals(name)) {
                return team;
            }
        }
        if (!name.chars().allMatch(character -> character > ' ' && character != '(' && character != ')')) {
            throw new JoinRefusedException(
                    "team name \"" + name + "\" has spaces or parentheses, which messages to other agents cannot"
                            + " contain; choose a name without them");
        }
        if (teams.size() == 2) {
            throw new JoinRefusedException("teams \"" + teams.get(0).name() + "\" and \""
                    + teams.get(1).name() + "\" are already playing; there is no room for team \"" + name + "\"");
        }
        TeamSide side = teams.isEmpty() ? TeamSide.LEFT : teams.get(0).side().opponent();
        Team team = new Team(name, side, parameters);
        teams.add(team);
        return team;
    }

    void save(StateWriter out, List<Robot> robots) {
        out.putAll(teams, team -> {
            out.putText(team.name());
            out.putEnum(team.side());
        });
        out.putAll(players, player -> {
            out.putInt(teams.indexOf(player.team()));
            out.putInt(player.number());
            out.putInt(robots.indexOf(player.robot()));
        });
        leftPositions.save(out);
        rightPositions.save(out);
    }

    /** Restores the state. Players whose team, number and robot are unchanged remain the same objects. */
    void restore(StateReader in, List<Robot> robots) {
        List<Team> formerTeams = List.copyOf(teams);
        teams.clear();
        teams.addAll(in.getAll(() -> team(in.getText(), in.getEnum(TeamSide.values()), formerTeams)));
        List<Player> formerPlayers = List.copyOf(players);
        players.clear();
        players.addAll(in.getAll(() -> player(
                teams.get(in.getIndex(teams.size())),
                in.getInt(),
                robots.get(in.getIndex(robots.size())),
                formerPlayers)));
        players.forEach(player -> player.team().add(player));
        leftPositions.restore(in);
        rightPositions.restore(in);
    }

    Roster roster() {
        return new Roster(teams, players, (name, side) -> new Team(name, side, parameters));
    }

    private Team team(String name, TeamSide side, List<Team> former) {
        Team team = former.stream()
                .filter(candidate -> candidate.name().equals(name))
                .findFirst()
                .orElseGet(() -> new Team(name, side, parameters));
        team.reset(side);
        return team;
    }

    private static Player player(Team team, int number, Robot robot, List<Player> former) {
        return former.stream()
                .filter(player -> player.team() == team && player.number() == number && player.robot() == robot)
                .findFirst()
                .orElseGet(() -> new Player(team, number, robot));
    }
}
