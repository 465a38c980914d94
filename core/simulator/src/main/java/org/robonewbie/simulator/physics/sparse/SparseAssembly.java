package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

final class SparseAssembly implements Assembly, Restorable {

    private final SparsePhysicsWorld world;
    private final OdeCollisions.Group odeGeometries;
    private final boolean removable;
    private final ContactLimit contactLimit = new ContactLimit();
    private final List<Body> bodies = new ArrayList<>();
    private final List<HingeJoint> hinges = new ArrayList<>();
    private final List<ShapeGroup> groups = new ArrayList<>();
    private final List<CollisionShape> staticShapes = new ArrayList<>();

    SparseAssembly(SparsePhysicsWorld world, OdeCollisions.Group odeGeometries, boolean removable) {
        this.world = world;
        this.odeGeometries = odeGeometries;
        this.removable = removable;
    }

    @Override
    public RigidBody addBody(MassDistribution mass, Vector3 position) {
        Body body = new Body(mass, position, world.detector().updates());
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
    public Collider addCollider(RigidBody body, BodyPose pose, Shape shape, Material material, Object owner) {
        Body sparseBody = (Body) body;
        SparseCollider collider = new SparseCollider(
                sparseBody, world.surfaces().indexOf(material), owner, removable ? contactLimit : null);
        OdeCollisions.Geometry odeGeometry = odeGeometries.add(shape, collider, true);
        CollisionShape placed = attached(sparseBody, pose, shape, collider, odeGeometry);
        sparseBody.attach(placed);
        currentGroup().add(placed);
        return collider;
    }

    private static CollisionShape attached(
            Body body, BodyPose pose, Shape shape, SparseCollider collider, OdeCollisions.Geometry odeGeometry) {
        if (pose.equals(BodyPose.ORIGIN)) {
            return CollisionShape.of(shape, collider, body.centre(), body.rotation, odeGeometry);
        }
        ShapeOffset offset = new ShapeOffset(pose);
        body.attach(offset);
        return CollisionShape.of(shape, collider, offset.position, offset.rotation, odeGeometry);
    }

    @Override
    public Collider addFixture(BodyPose pose, Shape shape, Material material, Object owner) {
        return place(pose, shape, new SparseCollider(null, world.surfaces().indexOf(material), owner, null));
    }

    @Override
    public Collider addTrigger(BodyPose pose, Shape shape, Object owner) {
        return place(pose, shape, new SparseCollider(null, SparseCollider.NO_MATERIAL, owner, null));
    }

    /**
     * Returns the group for a new shape. The shapes of a robot form one group, because they do not collide with each
     * other; each shape of the scenery is its own group.
     */
    private ShapeGroup currentGroup() {
        if (groups.isEmpty() || !removable) {
            ShapeGroup group = new ShapeGroup();
            groups.add(group);
            world.detector().add(group);
        }
        return groups.get(groups.size() - 1);
    }

    private Collider place(BodyPose pose, Shape shape, SparseCollider collider) {
        double[] rotation = new double[9];
        Rotations.copy(pose.rotation(), rotation);
        Vector3 position = pose.position();
        double[] place = {position.x(), position.y(), position.z()};
        CollisionShape placed =
                CollisionShape.of(shape, collider, place, rotation, odeGeometries.add(shape, collider, false));
        staticShapes.add(placed);
        world.detector().addStatic(placed);
        return collider;
    }

    @Override
    public void remove() {
        if (!removable) {
            throw new UnsupportedOperationException("The scenery cannot be removed. Discard the whole world instead.");
        }
        world.remove(this, bodies);
        odeGeometries.remove();
        groups.forEach(world.detector()::remove);
        staticShapes.forEach(world.detector()::removeStatic);
        bodies.clear();
    }

    @Override
    public void save(StateWriter out) {
        bodies.forEach(body -> body.save(out));
        hinges.forEach(hinge -> hinge.save(out));
        groups.forEach(group -> group.shapes().forEach(shape -> shape.save(out)));
    }

    @Override
    public void restore(StateReader in) {
        bodies.forEach(body -> body.restore(in));
        hinges.forEach(hinge -> hinge.restore(in));
        groups.forEach(group -> group.shapes().forEach(shape -> shape.restore(in)));
    }
}
