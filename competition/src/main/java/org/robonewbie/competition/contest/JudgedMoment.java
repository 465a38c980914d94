package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * What is true on the pitch at the end of one cycle, as each team sees it.
 *
 * @param trial the trial
 * @param seconds simulated seconds since its start
 * @param world the world
 */
public record JudgedMoment(ContestTrial trial, double seconds, WorldSnapshot world) {

    /**
     * Returns the half of a team. A robot alone on the pitch is identified by that, whatever it calls its team.
     *
     * @param team name of the team
     * @return its half, or empty while it has no robot
     */
    public Optional<TeamSide> side(String team) {
        return robotsOf(team).stream().findFirst().flatMap(RobotSnapshot::side);
    }

    /**
     * Returns the robots of a team.
     *
     * @param team name of the team
     * @return its robots in the order of their numbers
     */
    public List<RobotView> robots(String team) {
        return robotsOf(team).stream().map(RobotView::new).toList();
    }

    /**
     * Returns the goals of a side.
     *
     * @param side the side of the pitch
     * @return goals of the team that plays there
     */
    public int goals(TeamSide side) {
        return side == TeamSide.LEFT ? world.scoreLeft() : world.scoreRight();
    }

    /**
     * Returns the position of the ball in a team's own coordinates.
     *
     * @param side the side of the pitch
     * @return its centre: x to the opponents' goal, y to the left, metres
     */
    public Vector3 ball(TeamSide side) {
        return turned(world.ballPosition(), side);
    }

    /**
     * Turns a place of the world so that x points to the opponents' goal.
     *
     * @param place a place in the world frame, metres
     * @param side the side of the pitch on which one plays
     * @return the same place as seen by those who play there
     */
    static Vector3 turned(Vector3 place, TeamSide side) {
        return side == TeamSide.LEFT ? place : new Vector3(-place.x(), -place.y(), place.z());
    }

    private List<RobotSnapshot> robotsOf(String team) {
        return world.robots().stream()
                .filter(robot -> robot.side().isPresent())
                .filter(robot -> trial.isSolo() || robot.team().equals(team))
                .sorted((one, other) -> Integer.compare(one.number(), other.number()))
                .toList();
    }
}
