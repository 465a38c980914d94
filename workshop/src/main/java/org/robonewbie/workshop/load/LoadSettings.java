package org.robonewbie.workshop.load;

/**
 * The load on a server.
 *
 * @param robots the number of agents, 2 to 22
 * @param secondsOfPlay length of a match, both halves together, in simulated seconds
 * @param matches the number of matches in sequence
 * @param realTime whether the world runs on the clock; otherwise it waits for all agents and runs as fast as it can
 */
public record LoadSettings(int robots, double secondsOfPlay, int matches, boolean realTime) {}
