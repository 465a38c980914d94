package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MassDistribution;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** Bodies, hinges and forms that belong together. */
final class SparseAssembly implements Assembly {

    private final SparsePhysicsWorld world;
    private final OdeCollisions.Group group;
    private final boolean removable;
    private final List<Body> bodies = new ArrayList<>();

    SparseAssembly(SparsePhysicsWorld world, OdeCollisions.Group group, boolean removable) {
        this.world = world;
        this.group = group;
        this.removable = removable;
    }

    @Override
    public RigidBody addBody(MassDistribution mass, Vector3 position) {
        Body body = new Body(mass, position);
        bodies.add(body);
        world.add(body);
        return body;
    }

    @Override
    public MotorHinge addHinge(RigidBody child, RigidBody parent, HingeDefinition definition) {
        HingeJoint hinge = new HingeJoint((Body) child, (Body) parent, definition);
        hinge.attach();
        return hinge;
    }

    @Override
    public Collider addCollider(RigidBody body, Shape shape, Material material, Object owner) {
        Body carrier = (Body) body;
        SparseCollider collider = new SparseCollider(carrier, material, owner);
        carrier.attach(group.add(shape, collider));
        return collider;
    }

    @Override
    public Collider addFixture(Pose pose, Shape shape, Material material, Object owner) {
        return place(pose, shape, new SparseCollider(null, material, owner));
    }

    @Override
    public Collider addTrigger(Pose pose, Shape shape, Object owner) {
        return place(pose, shape, new SparseCollider(null, null, owner));
    }

    private Collider place(Pose pose, Shape shape, SparseCollider collider) {
        double[] rotation = new double[9];
        Rotations.copy(pose.rotation(), rotation);
        Vector3 position = pose.position();
        group.add(shape, collider).place(new double[] {position.x(), position.y(), position.z()}, rotation);
        return collider;
    }

    @Override
    public void remove() {
        if (!removable) {
            throw new UnsupportedOperationException("The scenery cannot be removed. Drop the whole world instead.");
        }
        world.remove(bodies);
        group.remove();
        bodies.clear();
    }
}
