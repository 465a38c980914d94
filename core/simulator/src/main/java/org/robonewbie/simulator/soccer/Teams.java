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
 * The two teams: the first team name to appear plays on the left, the second on the right, and both stay reserved when their
 * players leave (SimSpark: {@code gamestateaspect.cpp}), until the game is reset.
 */
public final class Teams {

    private final SoccerParameters parameters;
    private final List<Team> teams = new ArrayList<>();
    private final List<Player> players = new ArrayList<>();
    private final List<Player> readOnly = Collections.unmodifiableList(players);
    private final StartPositions leftPlaces;
    private final StartPositions rightPlaces;

    Teams(SoccerParameters parameters) {
        this.parameters = parameters;
        leftPlaces = new StartPositions(TeamSide.LEFT, parameters);
        rightPlaces = new StartPositions(TeamSide.RIGHT, parameters);
    }

    /** {@return all players of both teams in the order in which they joined, unmodifiable} */
    public List<Player> players() {
        return readOnly;
    }

    /**
     * Returns the team of a side.
     *
     * @param side the half that it defends
     * @return the team; empty before it has joined
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
     * Returns the name of a team.
     *
     * @param side the half that it defends
     * @return its name, empty before it has joined
     */
    public String name(TeamSide side) {
        return team(side).map(Team::name).orElse("");
    }

    /**
     * Looks up a player.
     *
     * @param side the half that the team defends
     * @param number the player's number
     * @return the player; empty if there is none
     */
    public Optional<Player> player(TeamSide side, int number) {
        return players.stream()
                .filter(player -> player.side() == side && player.number() == number)
                .findFirst();
    }

    /** Looks up whose body a robot is. */
    Optional<Player> playerOf(Robot robot) {
        for (int i = 0; i < players.size(); i++) {
            if (players.get(i).robot() == robot) {
                return Optional.of(players.get(i));
            }
        }
        return Optional.empty();
    }

    /**
     * Takes a robot into a team and puts it to the side line of its half.
     *
     * @param name the team's name
     * @param number the wanted number, 0 for the lowest free one
     * @param robot the robot
     * @return the new player
     * @throws JoinRefusedException if team, number or robot type are not allowed; the message says why
     */
    public Player join(String name, int number, Robot robot) throws JoinRefusedException {
        Team team = findOrFound(name);
        Optional<String> objection = team.objection(number, robot.model().type());
        if (objection.isPresent()) {
            throw new JoinRefusedException(objection.get());
        }
        Player player = team.add(number, robot);
        players.add(player);
        putToStart(player);
        return player;
    }

    /**
     * Takes a player out of its team; the number becomes free.
     *
     * @param player the player that leaves
     */
    public void leave(Player player) {
        players.remove(player);
        player.team().remove(player);
    }

    /**
     * Moves a player to where a new player of its team appears.
     *
     * @param player the player
     */
    public void putToStart(Player player) {
        boolean left = player.side() == TeamSide.LEFT;
        player.robot().moveUpright((left ? leftPlaces : rightPlaces).next(), left ? -90 : 90);
    }

    /** Frees the names of teams without players, so that others can play. */
    void forgetEmpty() {
        teams.removeIf(team -> team.players().isEmpty());
    }

    /** Replaces a player's body. */
    Player replaceRobot(Player old, Robot robot) {
        Player replacement = new Player(old.team(), old.number(), robot);
        old.team().replace(old, replacement);
        players.set(players.indexOf(old), replacement);
        return replacement;
    }

    void changeSides() {
        teams.forEach(Team::changeSide);
    }

    private Team findOrFound(String name) throws JoinRefusedException {
        for (Team team : teams) {
            if (team.name().equals(name)) {
                return team;
            }
        }
        if (!name.chars().allMatch(character -> character > ' ' && character != '(' && character != ')')) {
            throw new JoinRefusedException(
                    "team name \"" + name + "\" has blanks or parentheses, which no message to the"
                            + " others could carry; choose a name without");
        }
        if (teams.size() == 2) {
            throw new JoinRefusedException("teams \"" + teams.get(0).name() + "\" and \""
                    + teams.get(1).name() + "\" play already; a third team \"" + name + "\" cannot");
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
        leftPlaces.save(out);
        rightPlaces.save(out);
    }

    /** Takes on a state; players with the same team, number and robot as before stay the same objects. */
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
        leftPlaces.restore(in);
        rightPlaces.restore(in);
    }

    Roster roster() {
        return new Roster(teams, players, (name, side) -> new Team(name, side, parameters));
    }

    private Team team(String name, TeamSide side, List<Team> former) {
        Team team = former.stream()
                .filter(candidate -> candidate.name().equals(name))
                .findFirst()
                .orElseGet(() -> new Team(name, side, parameters));
        team.begin(side);
        return team;
    }

    private static Player player(Team team, int number, Robot robot, List<Player> former) {
        return former.stream()
                .filter(player -> player.team() == team && player.number() == number && player.robot() == robot)
                .findFirst()
                .orElseGet(() -> new Player(team, number, robot));
    }
}
