package org.robonewbie.simulator.recording;

import org.robonewbie.nao.model.RobotType;

/**
 * A robot that a recording names.
 *
 * @param id number of its agent's connection
 * @param type its build
 * @param side 0 without a team, 1 for the left team, 2 for the right one
 * @param number on its shirt, 0 without one
 * @param team name of its team, empty without one
 */
public record ListedRobot(int id, RobotType type, int side, int number, String team) {}
