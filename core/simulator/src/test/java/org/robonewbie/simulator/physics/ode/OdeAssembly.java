package org.robonewbie.simulator.physics.ode;

import java.util.ArrayList;
import java.util.List;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DHashSpace;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;

/** A collision space of ODE with the bodies and joints that were made for it. */
final class OdeAssembly implements Assembly {

    private final DWorld world;
    private final DHashSpace space;
    private final boolean removable;
    private final List<OdeBody> bodies = new ArrayList<>();
    private final List<OdeHinge> hinges = new ArrayList<>();

    private OdeAssembly(DWorld world, DHashSpace space, boolean removable) {
        this.world = world;
        this.space = space;
        this.removable = removable;
    }

    static OdeAssembly within(DWorld world, DSpace parent) {
        return new OdeAssembly(world, OdeHelper.createHashSpace(parent), true);
    }

    static OdeAssembly scenery(DWorld world, DHashSpace space) {
        return new OdeAssembly(world, space, false);
    }

    @Override
    public RigidBody addBody(MassDistribution mass, Vector3 position) {
        OdeBody body = new OdeBody(world, mass, position);
        bodies.add(body);
        return body;
    }

    @Override
    public MotorHinge addHinge(RigidBody child, RigidBody parent, HingeDefinition definition) {
        OdeHinge hinge = new OdeHinge(world, (OdeBody) child, (OdeBody) parent, definition);
        hinges.add(hinge);
        return hinge;
    }

    @Override
    public Collider addCollider(RigidBody body, BodyPose pose, Shape shape, Material material, Object owner) {
        DGeom geometry = OdeCollisions.geometry(space, shape);
        geometry.setBody(((OdeBody) body).body());
        if (!pose.equals(BodyPose.ORIGIN)) {
            geometry.setOffsetPosition(
                    pose.position().x(), pose.position().y(), pose.position().z());
            geometry.setOffsetRotation(OdeVectors.to(pose.rotation()));
        }
        return OdeCollider.solid(geometry, material, owner);
    }

    @Override
    public Collider addFixture(BodyPose pose, Shape shape, Material material, Object owner) {
        return OdeCollider.solid(placed(shape, pose), material, owner);
    }

    @Override
    public Collider addTrigger(BodyPose pose, Shape shape, Object owner) {
        return OdeCollider.trigger(placed(shape, pose), owner);
    }

    @Override
    public void remove() {
        if (!removable) {
            throw new UnsupportedOperationException("The scenery cannot be removed. Discard the whole world instead.");
        }
        hinges.forEach(hinge -> hinge.joint().destroy());
        bodies.forEach(body -> body.body().destroy());
        space.destroy();
        hinges.clear();
        bodies.clear();
    }

    private DGeom placed(Shape shape, BodyPose pose) {
        DGeom geometry = OdeCollisions.geometry(space, shape);
        geometry.setPosition(
                pose.position().x(), pose.position().y(), pose.position().z());
        geometry.setRotation(OdeVectors.to(pose.rotation()));
        return geometry;
    }
}
