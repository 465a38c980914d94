package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.world.Robot;

/** Team in a match. */
public final class Team {

    /** Maximum number of players, and the highest shirt number. */
    public static final int SIZE = 11;

    private final String name;
    private final SoccerParameters parameters;
    private final List<Player> players = new ArrayList<>();
    private final List<Player> readOnly = Collections.unmodifiableList(players);
    private TeamSide side;

    Team(String name, TeamSide side, SoccerParameters parameters) {
        this.name = name;
        this.side = side;
        this.parameters = parameters;
    }

    /** {@return the team name as given by its first player, possibly empty} */
    public String name() {
        return name;
    }

    /** {@return the half that the team currently defends} */
    public TeamSide side() {
        return side;
    }

    /** {@return the players in the order in which they joined, unmodifiable} */
    public List<Player> players() {
        return readOnly;
    }

    void changeSide() {
        side = side.opponent();
    }

    /** Returns the reason why a robot may not join; empty if it may. Number 0 requests any free number. */
    Optional<String> objection(int number, RobotType type) {
        if (players.size() >= SIZE) {
            return Optional.of("team \"" + name + "\" already has all " + SIZE + " players");
        }
        if (number < 0 || number > SIZE) {
            return Optional.of("number " + number + " does not exist; choose 1 to " + SIZE);
        }
        if (isTaken(number)) {
            return Optional.of("number " + number + " of team \"" + name
                    + "\" is taken; choose another one, or 0 for any free one");
        }
        return typeObjection(type);
    }

    /** Adds a robot; number 0 requests the lowest free number. */
    Player add(int number, Robot robot) {
        Player player = new Player(this, number == 0 ? lowestFreeNumber() : number, robot);
        players.add(player);
        return player;
    }

    /** Resets the team before a saved match is restored. */
    void reset(TeamSide newSide) {
        side = newSide;
        players.clear();
    }

    void add(Player player) {
        players.add(player);
    }

    void remove(Player player) {
        players.remove(player);
    }

    void replace(Player old, Player replacement) {
        players.set(players.indexOf(old), replacement);
    }

    private Optional<String> typeObjection(RobotType type) {
        int limit = (int) parameters.get(SoccerParameter.MAX_ROBOT_TYPE_COUNT);
        if (count(type) >= limit) {
            return Optional.of("team \"" + name + "\" already has " + count(type) + " robots of type " + type.ordinal()
                    + " and MaxRobotTypeCount is " + limit + "; choose another type");
        }
        int pairLimit = (int) parameters.get(SoccerParameter.MAX_SUM_TWO_ROBOT_TYPES);
        for (RobotType other : RobotType.values()) {
            if (other != type && count(other) > 0 && count(type) + count(other) >= pairLimit) {
                return Optional.of("team \"" + name + "\" already has " + pairLimit + " robots of types "
                        + type.ordinal() + " and " + other.ordinal()
                        + ", which is MaxSumTwoRobotTypes; choose another type");
            }
        }
        int missing = (int) parameters.get(SoccerParameter.MIN_ROBOT_TYPES_COUNT) - typesPresent();
        if (count(type) > 0 && SIZE - players.size() <= missing) {
            return Optional.of("team \"" + name + "\" needs " + missing
                    + " more types for a full team (MinRobotTypesCount); choose a type that it does not have yet");
        }
        return Optional.empty();
    }

    private int count(RobotType type) {
        return (int)
                players.stream().filter(player -> player.robot().type() == type).count();
    }

    private int typesPresent() {
        return (int)
                players.stream().map(player -> player.robot().type()).distinct().count();
    }

    private boolean isTaken(int number) {
        return players.stream().anyMatch(player -> player.number() == number);
    }

    private int lowestFreeNumber() {
        int number = 1;
        while (isTaken(number)) {
            number++;
        }
        return number;
    }
}
