package org.robonewbie.simulator.sensing;

import org.robonewbie.simulator.world.Robot;

/**
 * A robot that belongs to a team and can be recognised by its shirt.
 *
 * @param robot its body
 * @param team name of its team
 * @param number number on its shirt
 */
public record VisiblePlayer(Robot robot, String team, int number) {}
