package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Material;

/**
 * A surface.
 *
 * @param body what carries it; none for ground, walls and triggers
 * @param material what it is made of; none for a trigger
 * @param owner what it belongs to
 */
record SparseCollider(@Nullable Body body, @Nullable Material material, Object owner) implements Collider {

    @Override
    public boolean equals(@Nullable Object other) {
        return this == other;
    }

    @Override
    public int hashCode() {
        return System.identityHashCode(this);
    }
}
