package org.robonewbie.simulator.world;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/** Soccer ball: a soft sphere that bounces, rolls and is slowed down by air drag. */
public final class Ball {

    private static final double LINEAR_DRAG = 0.01;
    private static final double ANGULAR_DRAG = 5e-5;

    private final BallProperties properties;
    private final RigidBody body;

    Ball(Assembly scenery, BallProperties properties) {
        this.properties = properties;
        Shape shape = new Shape.Sphere(properties.radius());
        body = scenery.addBody(MassDistribution.of(shape, properties.massKg()), new Vector3(0, 0, properties.radius()));
        scenery.addCollider(body, BodyPose.ORIGIN, shape, SurfaceMaterials.BALL, this);
    }

    /** {@return the radius and mass of the ball} */
    public BallProperties properties() {
        return properties;
    }

    /** {@return the position of the centre in the world frame in metres} */
    public Vector3 position() {
        return body.position();
    }

    /** {@return the velocity in the world frame in metres per second} */
    public Vector3 velocity() {
        return body.velocity();
    }

    /** {@return the angular velocity about the world axes in radians per second} */
    public Vector3 spin() {
        return body.angularVelocity();
    }

    /** {@return the rotation from ball to world axes} */
    public RotationMatrix rotation() {
        return body.rotation();
    }

    /**
     * Moves the ball without changing its velocity or spin, as a trainer does.
     *
     * @param position position in the world frame in metres, limited to 1 km per axis
     */
    public void moveTo(Vector3 position) {
        body.setPosition(WorldLimits.position(position));
        body.wake();
    }

    /**
     * Sets the velocity and stops the spin, as a trainer does.
     *
     * @param metresPerSecond velocity in the world frame, limited to 1000 m/s per axis
     */
    public void setVelocity(Vector3 metresPerSecond) {
        body.setVelocity(WorldLimits.velocity(metresPerSecond));
        body.setAngularVelocity(Vector3.ZERO);
        body.wake();
    }

    /**
     * Places the ball at rest, as the referee does.
     *
     * @param position position in the world frame in metres
     */
    public void place(Vector3 position) {
        moveTo(position);
        setVelocity(Vector3.ZERO);
    }

    /**
     * Sets the pose, velocity and spin.
     *
     * @param motion pose, velocity and spin
     */
    public void place(LinkMotion motion) {
        moveTo(motion.pose().position());
        body.setRotation(motion.pose().rotation());
        setVelocity(motion.velocity());
        body.setAngularVelocity(motion.radiansPerSecond());
    }

    /** Moves a ball that has left the world limits back to the centre spot. */
    void finishStep() {
        if (!WorldLimits.isWithin(body)) {
            body.setRotation(RotationMatrix.IDENTITY);
            place(new Vector3(0, 0, properties.radius()));
        }
    }

    void applyDrag() {
        body.addDamping(LINEAR_DRAG, ANGULAR_DRAG);
    }
}
