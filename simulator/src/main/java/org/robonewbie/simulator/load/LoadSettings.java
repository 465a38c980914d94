package org.robonewbie.simulator.load;

import org.robonewbie.simulator.world.PhysicsEngine;

/**
 * How much a server has to do.
 *
 * @param robots how many agents play, 2 to 22
 * @param secondsOfPlay length of a match, both halves together, in simulated seconds
 * @param matches how many are played one after the other
 * @param realTime whether the world runs on the clock; else it waits for all agents and runs as fast as it can
 * @param physics the engine that moves the world
 */
public record LoadSettings(int robots, double secondsOfPlay, int matches, boolean realTime, PhysicsEngine physics) {}
