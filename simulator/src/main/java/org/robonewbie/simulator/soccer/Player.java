package org.robonewbie.simulator.soccer;

import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.BoundingBox;
import org.robonewbie.simulator.world.Robot;

/** A robot that has joined a team. */
public final class Player {

    private final Team team;
    private final int number;
    private final Robot robot;
    private final Conduct conduct;

    Player(Team team, int number, Robot robot) {
        this.team = team;
        this.number = number;
        this.robot = robot;
        this.conduct = new Conduct(robot.model().hinges().size());
    }

    /**
     * Names the team.
     *
     * @return the player's team
     */
    public Team team() {
        return team;
    }

    /**
     * Tells on which side the team plays at present.
     *
     * @return the half that the team defends
     */
    public TeamSide side() {
        return team.side();
    }

    /**
     * Tells the number on the shirt; number 1 keeps the goal.
     *
     * @return 1 to 11
     */
    public int number() {
        return number;
    }

    /**
     * Gives access to the body.
     *
     * @return the robot
     */
    public Robot robot() {
        return robot;
    }

    /**
     * Tells where the player is.
     *
     * @return the torso's centre in the world frame, metres
     */
    public Vector3 position() {
        return robot.torso().position();
    }

    Conduct conduct() {
        return conduct;
    }

    boolean isGoalkeeper() {
        return number == 1;
    }

    /** Tells whether the box around the robot comes nearer to a point than a distance in metres. */
    boolean isWithin(double distance, Vector3 point) {
        BoundingBox box = robot.boundingBox();
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
