package org.robonewbie.studio.scene;

import org.robonewbie.simulator.WorldSnapshot;

/**
 * A state of the world from which a simulation can go on.
 *
 * @param before some cycles earlier, from which velocities follow; the same state for a world at rest
 * @param state the state itself
 */
public record KeptMoment(WorldSnapshot before, WorldSnapshot state) {}
