package org.robonewbie.agent.league;

import org.robonewbie.robot.RobotModel;

/**
 * Which robot joins, and for whom.
 *
 * @param model the robot to play with
 * @param team name of its team
 * @param number its player number, 1 to 11
 */
public record LeaguePlayer(RobotModel model, String team, int number) {}
