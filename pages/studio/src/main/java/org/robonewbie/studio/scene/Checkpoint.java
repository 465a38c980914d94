package org.robonewbie.studio.scene;

import java.util.Optional;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/**
 * A state of the world from which a simulation can go on.
 *
 * @param before some cycles earlier, from which velocities follow; the same state for a world at rest
 * @param state the state itself
 * @param exact the state to the bit, where it was saved
 */
public record Checkpoint(WorldSnapshot before, WorldSnapshot state, Optional<WorldState> exact) {}
