package org.robonewbie.studio.scene;

import java.util.Optional;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/**
 * A state of the world from which a simulation can continue.
 *
 * @param before the state a few cycles earlier, used to estimate velocities; for a world at rest, the same state
 * @param state the state itself
 * @param exact the bit-exact state, if it was saved
 */
public record Checkpoint(WorldSnapshot before, WorldSnapshot state, Optional<WorldState> exact) {}
