package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MassDistribution;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** Bodies, hinges and shapes that belong together. */
final class SparseAssembly implements Assembly, Restorable {

    private final SparsePhysicsWorld world;
    private final OdeCollisions.Group odeGeometries;
    private final boolean removable;
    private final ContactLimit budget = new ContactLimit();
    private final List<Body> bodies = new ArrayList<>();
    private final List<HingeJoint> hinges = new ArrayList<>();
    private final List<ShapeGroup> movers = new ArrayList<>();
    private final List<CollisionShape> fixtures = new ArrayList<>();

    SparseAssembly(SparsePhysicsWorld world, OdeCollisions.Group odeGeometries, boolean removable) {
        this.world = world;
        this.odeGeometries = odeGeometries;
        this.removable = removable;
    }

    @Override
    public RigidBody addBody(MassDistribution mass, Vector3 position) {
        Body body = new Body(mass, position, world.finder().order());
        bodies.add(body);
        world.add(body);
        return body;
    }

    @Override
    public MotorHinge addHinge(RigidBody child, RigidBody parent, HingeDefinition definition) {
        HingeJoint hinge = new HingeJoint((Body) child, (Body) parent, definition);
        hinge.attach();
        hinges.add(hinge);
        return hinge;
    }

    @Override
    public Collider addCollider(RigidBody body, Shape shape, Material material, Object owner) {
        Body carrier = (Body) body;
        SparseCollider collider =
                new SparseCollider(carrier, world.surfaces().numberOf(material), owner, removable ? budget : null);
        OdeCollisions.Geometry odeGeometry = odeGeometries.add(shape, collider, true);
        CollisionShape placed = CollisionShape.of(shape, collider, carrier.place(), carrier.rotation, odeGeometry);
        carrier.attach(placed);
        groupOfNext().add(placed);
        return collider;
    }

    @Override
    public Collider addFixture(BodyPose pose, Shape shape, Material material, Object owner) {
        return place(pose, shape, new SparseCollider(null, world.surfaces().numberOf(material), owner, null));
    }

    @Override
    public Collider addTrigger(BodyPose pose, Shape shape, Object owner) {
        return place(pose, shape, new SparseCollider(null, SparseCollider.NO_MATERIAL, owner, null));
    }

    /** A robot's parts never touch each other and shape one group; each part of the scenery is a group by itself. */
    private ShapeGroup groupOfNext() {
        if (movers.isEmpty() || !removable) {
            ShapeGroup group = new ShapeGroup();
            movers.add(group);
            world.finder().add(group);
        }
        return movers.get(movers.size() - 1);
    }

    private Collider place(BodyPose pose, Shape shape, SparseCollider collider) {
        double[] rotation = new double[9];
        Rotations.copy(pose.rotation(), rotation);
        Vector3 position = pose.position();
        double[] place = {position.x(), position.y(), position.z()};
        CollisionShape placed =
                CollisionShape.of(shape, collider, place, rotation, odeGeometries.add(shape, collider, false));
        fixtures.add(placed);
        world.finder().addFixture(placed);
        return collider;
    }

    @Override
    public void remove() {
        if (!removable) {
            throw new UnsupportedOperationException("The scenery cannot be removed. Drop the whole world instead.");
        }
        world.remove(this, bodies);
        odeGeometries.remove();
        movers.forEach(world.finder()::remove);
        fixtures.forEach(world.finder()::removeFixture);
        bodies.clear();
    }

    @Override
    public void save(StateWriter out) {
        bodies.forEach(body -> body.save(out));
        hinges.forEach(hinge -> hinge.save(out));
        movers.forEach(group -> group.shapes().forEach(shape -> shape.save(out)));
    }

    @Override
    public void restore(StateReader in) {
        bodies.forEach(body -> body.restore(in));
        hinges.forEach(hinge -> hinge.restore(in));
        movers.forEach(group -> group.shapes().forEach(shape -> shape.restore(in)));
    }
}
