package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;

/**
 * Group of bodies and colliders, such as a robot or a goal. Its colliders do not collide with each other, unless the
 * assembly is the scenery.
 */
public interface Assembly {

    /**
     * Adds a body at rest whose axes are parallel to the world axes.
     *
     * @param mass mass and inertia
     * @param position centre of mass in metres
     * @return the new body
     */
    RigidBody addBody(MassDistribution mass, Vector3 position);

    /**
     * Connects two bodies with a hinge whose angle is 0 in their current pose.
     *
     * @param child the outer body; a positive angle rotates it relative to the parent by the right-hand rule
     * @param parent the inner body
     * @param definition geometry, stops and motor of the hinge
     * @return the new hinge with motor speed 0
     */
    MotorHinge addHinge(RigidBody child, RigidBody parent, HingeDefinition definition);

    /**
     * Attaches a collision shape to a body.
     *
     * @param body the body
     * @param pose pose of the shape's centre relative to the body; {@link BodyPose#ORIGIN} for a shape around its centre of mass
     * @param shape the shape
     * @param material material of the surface
     * @param owner the object that the collider belongs to; see {@link Collider#owner()}
     * @return the new collider
     */
    Collider addCollider(RigidBody body, BodyPose pose, Shape shape, Material material, Object owner);

    /**
     * Adds a static collider.
     *
     * @param pose pose of the shape's centre
     * @param shape the shape
     * @param material material of the surface
     * @param owner the object that the collider belongs to; see {@link Collider#owner()}
     * @return the new collider
     */
    Collider addFixture(BodyPose pose, Shape shape, Material material, Object owner);

    /**
     * Adds a static trigger, which reports contacts without exerting forces.
     *
     * @param pose pose of the shape's centre
     * @param shape the shape
     * @param owner the object that the collider belongs to; see {@link Collider#owner()}
     * @return the new collider
     */
    Collider addTrigger(BodyPose pose, Shape shape, Object owner);

    /**
     * Removes all bodies, hinges and colliders from the world. They must not be used afterwards.
     *
     * @throws UnsupportedOperationException for the scenery
     */
    void remove();
}
