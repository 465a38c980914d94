package org.robonewbie.workshop.load;

/**
 * Load on a server.
 *
 * @param robots number of agents, 2 to 22
 * @param secondsOfPlay length of a match, both halves together, in simulated seconds
 * @param matches number of consecutive matches
 * @param realTime whether the server runs in real time; otherwise it waits for all agents and runs as fast as possible
 */
public record LoadSettings(int robots, double secondsOfPlay, int matches, boolean realTime) {}
