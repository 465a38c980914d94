package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.MassDistribution;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.Rotation;

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

    /**
     * Tells size and weight.
     *
     * @return what the ball was made with
     */
    public BallProperties properties() {
        return properties;
    }

    /**
     * Tells where the ball is.
     *
     * @return its centre in the world frame, metres
     */
    public Vector3 position() {
        return body.position();
    }

    /**
     * Tells how fast the ball flies or rolls.
     *
     * @return metres per second in the world frame
     */
    public Vector3 velocity() {
        return body.velocity();
    }

    /**
     * Tells how fast the ball spins.
     *
     * @return radians per second about the world's axes
     */
    public Vector3 spin() {
        return body.angularVelocity();
    }

    /**
     * Tells how the ball is turned.
     *
     * @return the rotation from its own axes to the world's
     */
    public Rotation rotation() {
        return body.rotation();
    }

    /**
     * Puts the ball somewhere as the trainer does: it keeps its velocity and spin.
     *
     * @param position centre of the ball in the world frame, metres; cut to a kilometre
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
     * Puts the ball somewhere at rest, as the referee does.
     *
     * @param position centre of the ball in the world frame, metres
     */
    public void place(Vector3 position) {
        moveTo(position);
        setVelocity(Vector3.ZERO);
    }

    /**
     * Gives the ball a place and a movement.
     *
     * @param motion where it is and how it moves and spins
     */
    public void place(LinkMotion motion) {
        moveTo(motion.pose().position());
        body.setRotation(motion.pose().rotation());
        setVelocity(motion.velocity());
        body.setAngularVelocity(motion.radiansPerSecond());
    }

    /** Puts a ball that went beyond all limits back to the centre spot. */
    void finishStep() {
        if (!WorldLimits.isWithin(body.position())) {
            body.setRotation(Rotation.IDENTITY);
            place(new Vector3(0, 0, properties.radius()));
        }
    }

    void applyDrag() {
        DRAG.applyTo(body);
    }
}
