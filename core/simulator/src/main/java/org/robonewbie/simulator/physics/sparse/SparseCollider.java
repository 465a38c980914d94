package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.Collider;

/** What is known of a surface but its shape. */
final class SparseCollider implements Collider {

    /** Stands for the material of a trigger, which lets everything through. */
    static final int NO_MATERIAL = -1;

    private final @Nullable Body body;
    private final int material;
    private final Object owner;
    private final @Nullable ContactLimit budget;
    private final LastTouch lastTouch = new LastTouch();

    /**
     * Creates a collider.
     *
     * @param body the body that carries it; none for ground, walls and triggers
     * @param material number of its material in {@link Surfaces}, or {@link #NO_MATERIAL}
     * @param owner what it belongs to
     * @param budget counts the contacts of its robot; none for everything else
     */
    SparseCollider(@Nullable Body body, int material, Object owner, @Nullable ContactLimit budget) {
        this.body = body;
        this.material = material;
        this.owner = owner;
        this.budget = budget;
    }

    @Nullable
    ContactLimit budget() {
        return budget;
    }

    /** What the solver remembers of the last touch of something that never moves. */
    LastTouch lastTouch() {
        return lastTouch;
    }

    @Nullable
    Body body() {
        return body;
    }

    int material() {
        return material;
    }

    @Override
    public Object owner() {
        return owner;
    }
}
