package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * One rigid body; its origin is its centre of mass.
 *
 * <p>A body that has rested for a while falls asleep with all that it is joined to, and is left out until {@link
 * #wake()} or a contact with a body that is awake. Moving it does not wake it.
 */
public interface RigidBody {

    /** {@return the position of the body's centre in metres} */
    Vector3 position();

    /** {@return the rotation from the body's own axes to the world's} */
    RotationMatrix rotation();

    /** {@return the body's position and orientation} */
    default BodyPose pose() {
        return new BodyPose(position(), rotation());
    }

    /** {@return the velocity of the centre in metres per second} */
    Vector3 velocity();

    /** {@return the angular velocity in radians per second about the world's axes} */
    Vector3 angularVelocity();

    /**
     * Moves the centre.
     *
     * @param position metres
     */
    void setPosition(Vector3 position);

    /**
     * Sets the orientation.
     *
     * @param rotation from its own axes to the world's
     */
    void setRotation(RotationMatrix rotation);

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
     * Makes the body heavier or lighter than it was made, and harder or easier to turn in proportion.
     *
     * @param factor the mass as a multiple of the first one, above 0
     */
    void setMassFactor(double factor);

    /** {@return whether the body rests and is left out of the step} */
    boolean isAsleep();

    /** Wakes the body, so that it takes part in the step again. */
    void wake();
}
