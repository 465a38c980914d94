package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.MassDistribution;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/** The ball: a soft sphere that bounces, rolls and is slowed by the air. */
public final class Ball {

    private static final Drag DRAG = new Drag(0.01, 5e-5);

    private final BallProperties properties;
    private final RigidBody body;

    Ball(Assembly scenery, BallProperties properties) {
        this.properties = properties;
        Shape shape = new Shape.Sphere(properties.radius());
        body = scenery.addBody(MassDistribution.of(shape, properties.massKg()), new Vector3(0, 0, properties.radius()));
        scenery.addCollider(body, shape, SurfaceMaterials.BALL, this);
    }

    /** {@return radius and mass of the ball} */
    public BallProperties properties() {
        return properties;
    }

    /** {@return the position of the centre in the world frame, metres} */
    public Vector3 position() {
        return body.position();
    }

    /** {@return the velocity in the world frame, metres per second} */
    public Vector3 velocity() {
        return body.velocity();
    }

    /** {@return the angular velocity in radians per second about the world's axes} */
    public Vector3 spin() {
        return body.angularVelocity();
    }

    /** {@return the rotation from the ball's own axes to the world's} */
    public RotationMatrix rotation() {
        return body.rotation();
    }

    /**
     * Moves the ball as a trainer does: it keeps its velocity and spin.
     *
     * @param position centre of the ball in the world frame, metres; limited to a kilometre
     */
    public void moveTo(Vector3 position) {
        body.setPosition(WorldLimits.place(position));
        body.wake();
    }

    /**
     * Sets the ball's speed as the trainer does: its spin is taken away.
     *
     * @param metresPerSecond velocity in the world frame; cut to 1000 m/s
     */
    public void setVelocity(Vector3 metresPerSecond) {
        body.setVelocity(WorldLimits.velocity(metresPerSecond));
        body.setAngularVelocity(Vector3.ZERO);
        body.wake();
    }

    /**
     * Places the ball at rest, as the referee does.
     *
     * @param position centre of the ball in the world frame, metres
     */
    public void place(Vector3 position) {
        moveTo(position);
        setVelocity(Vector3.ZERO);
    }

    /**
     * Sets the ball's position and motion.
     *
     * @param motion position, velocity and spin
     */
    public void place(LinkMotion motion) {
        moveTo(motion.pose().position());
        body.setRotation(motion.pose().rotation());
        setVelocity(motion.velocity());
        body.setAngularVelocity(motion.radiansPerSecond());
    }

    /** Returns a ball that went beyond all limits to the centre spot. */
    void finishStep() {
        if (!WorldLimits.isWithin(body)) {
            body.setRotation(RotationMatrix.IDENTITY);
            place(new Vector3(0, 0, properties.radius()));
        }
    }

    void applyDrag() {
        DRAG.applyTo(body);
    }
}
