package org.robonewbie.simulator.soccer;

import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.BoundingBox;
import org.robonewbie.simulator.world.Robot;

/** Robot that has joined a team. */
public final class Player {

    private final Team team;
    private final int number;
    private final @Nullable Robot robot;
    private final FoulHistory fouls;

    Player(Team team, int number, Robot robot) {
        this(team, number, robot, new FoulHistory(robot.nao().hinges().size()));
    }

    private Player(Team team, int number, @Nullable Robot robot, FoulHistory fouls) {
        this.team = team;
        this.number = number;
        this.robot = robot;
        this.fouls = fouls;
    }

    /** Creates a placeholder for a player that has left. */
    static Player departed(Team team, int number) {
        return new Player(team, number, null, new FoulHistory(0));
    }

    /** {@return the player's team} */
    public Team team() {
        return team;
    }

    /** {@return the half that the player's team currently defends} */
    public TeamSide side() {
        return team.side();
    }

    /** {@return the shirt number, 1 to 11; number 1 is the goalkeeper} */
    public int number() {
        return number;
    }

    /** {@return the player's robot} */
    public Robot robot() {
        if (robot == null) {
            throw new IllegalStateException(this + " has left the game");
        }
        return robot;
    }

    /** {@return the position of the torso in the world frame in metres} */
    public Vector3 position() {
        return robot().linkPosition(0);
    }

    FoulHistory fouls() {
        return fouls;
    }

    boolean isGoalkeeper() {
        return number == 1;
    }

    /** Returns whether the robot's bounding box is within the given distance, in metres, of a point. */
    boolean isWithin(double distance, Vector3 point) {
        BoundingBox box = robot().boundingBox();
        double x = gap(point.x(), box.min().x(), box.max().x());
        double y = gap(point.y(), box.min().y(), box.max().y());
        double z = gap(point.z(), box.min().z(), box.max().z());
        return x * x + y * y + z * z <= distance * distance;
    }

    @Override
    public String toString() {
        return "player " + number + " of " + team.name();
    }

    private static double gap(double value, double min, double max) {
        return Math.max(0, Math.max(min - value, value - max));
    }
}
