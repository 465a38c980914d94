package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * One rigid body; its origin is its centre of mass.
 *
 * <p>A body that has rested for a while falls asleep with all that it is joined to, and is left out until {@link
 * #wake()} or a contact with a body that is awake. Moving it does not wake it.
 */
public interface RigidBody {

    /**
     * Tells where the body is.
     *
     * @return its centre in metres
     */
    Vector3 position();

    /**
     * Tells how the body is turned.
     *
     * @return the rotation from its own axes to the world's
     */
    Rotation rotation();

    /**
     * Tells where the body is and how it is turned.
     *
     * @return its pose
     */
    default Pose pose() {
        return new Pose(position(), rotation());
    }

    /**
     * Tells how fast the centre moves.
     *
     * @return metres per second
     */
    Vector3 velocity();

    /**
     * Tells how fast the body turns.
     *
     * @return radians per second about the world's axes
     */
    Vector3 angularVelocity();

    /**
     * Puts the centre somewhere.
     *
     * @param position metres
     */
    void setPosition(Vector3 position);

    /**
     * Turns the body.
     *
     * @param rotation from its own axes to the world's
     */
    void setRotation(Rotation rotation);

    /**
     * Sets the speed of the centre.
     *
     * @param metresPerSecond the velocity
     */
    void setVelocity(Vector3 metresPerSecond);

    /**
     * Sets how fast the body turns.
     *
     * @param radiansPerSecond about the world's axes
     */
    void setAngularVelocity(Vector3 radiansPerSecond);

    /**
     * Pushes at the centre during the next step.
     *
     * @param newtons the force, added to others
     */
    void addForce(Vector3 newtons);

    /**
     * Twists during the next step.
     *
     * @param newtonMetres the torque, added to others
     */
    void addTorque(Vector3 newtonMetres);

    /**
     * Tells whether the body rests and is left out.
     *
     * @return true while it sleeps
     */
    boolean isAsleep();

    /** Lets a sleeping body take part again. */
    void wake();
}
