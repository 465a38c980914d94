package org.robonewbie.simulator.physics.sparse;

import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.Collider;

/** Body, material and owner of a collision shape. */
final class SparseCollider implements Collider {

    /** Material index of a trigger, which reports contacts without exerting forces. */
    static final int NO_MATERIAL = -1;

    private final @Nullable Body body;
    private final int material;
    private final Object owner;
    private final @Nullable ContactLimit contactLimit;
    private final ContactStateCache contactStates = new ContactStateCache();

    /**
     * Creates a collider.
     *
     * @param body the body to which it is attached; null for ground, walls and triggers
     * @param material index of its material in {@link Surfaces}, or {@link #NO_MATERIAL}
     * @param owner the object it belongs to
     * @param contactLimit contact limit of the robot; null for everything else
     */
    SparseCollider(@Nullable Body body, int material, Object owner, @Nullable ContactLimit contactLimit) {
        this.body = body;
        this.material = material;
        this.owner = owner;
        this.contactLimit = contactLimit;
    }

    @Nullable
    ContactLimit contactLimit() {
        return contactLimit;
    }

    ContactStateCache contactStates() {
        return contactStates;
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
