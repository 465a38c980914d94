package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;

/** Parts that belong together and, but for the scenery, never touch each other: the links of a robot, a goal's walls. */
public interface Assembly {

    /**
     * Adds a body at rest that is parallel to the world's axes.
     *
     * @param mass how heavy it is and how hard to turn
     * @param position its centre of mass in metres
     * @return the new body
     */
    RigidBody addBody(MassDistribution mass, Vector3 position);

    /**
     * Joins two bodies; the hinge's angle is 0 in their present pose.
     *
     * @param child the outer body; a positive angle turns it against the parent by the right-hand rule
     * @param parent the inner body
     * @param definition where the hinge is and how far and strong it turns
     * @return the new hinge, its motor at speed 0
     */
    MotorHinge addHinge(RigidBody child, RigidBody parent, HingeDefinition definition);

    /**
     * Attaches a collision shape to a body, centred in it.
     *
     * @param body the body
     * @param shape its shape
     * @param material the material of its surface
     * @param owner what it belongs to, see {@link Collider#owner()}
     * @return the new collider
     */
    Collider addCollider(RigidBody body, Shape shape, Material material, Object owner);

    /**
     * Adds something that never moves.
     *
     * @param pose where its centre is and how it is turned
     * @param shape its shape
     * @param material what its surface is made of
     * @param owner what it belongs to, see {@link Collider#owner()}
     * @return the new collider
     */
    Collider addFixture(BodyPose pose, Shape shape, Material material, Object owner);

    /**
     * Adds a volume that reports what is inside it and lets everything through.
     *
     * @param pose where its centre is and how it is turned
     * @param shape its shape
     * @param owner what it belongs to, see {@link Collider#owner()}
     * @return the new collider
     */
    Collider addTrigger(BodyPose pose, Shape shape, Object owner);

    /**
     * Takes all parts out of the world; they must not be used afterwards.
     *
     * @throws UnsupportedOperationException for the scenery
     */
    void remove();
}
