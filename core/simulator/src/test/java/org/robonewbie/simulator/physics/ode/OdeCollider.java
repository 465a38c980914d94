package org.robonewbie.simulator.physics.ode;

import java.util.Optional;
import java.util.OptionalDouble;
import org.ode4j.ode.DGeom;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Material;

/** A geometry of ODE that knows its owner and its material. */
final class OdeCollider implements Collider {

    private static final Material NOTHING =
            new Material(Optional.empty(), OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty());

    private final DGeom geometry;
    private final Material material;
    private final boolean solid;
    private final Object owner;

    private OdeCollider(DGeom geometry, Material material, boolean solid, Object owner) {
        this.geometry = geometry;
        this.material = material;
        this.solid = solid;
        this.owner = owner;
    }

    static OdeCollider solid(DGeom geometry, Material material, Object owner) {
        return attached(new OdeCollider(geometry, material, true, owner));
    }

    static OdeCollider trigger(DGeom geometry, Object owner) {
        return attached(new OdeCollider(geometry, NOTHING, false, owner));
    }

    private static OdeCollider attached(OdeCollider collider) {
        collider.geometry.setData(collider);
        return collider;
    }

    boolean isSolid() {
        return solid;
    }

    boolean hasBody() {
        return geometry.getBody() != null;
    }

    Material material() {
        return material;
    }

    @Override
    public Object owner() {
        return owner;
    }
}
