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

    /** {@return the direction of the body's own y axis in the world} */
    default Vector3 axisY() {
        return rotation().axisY();
    }

    /** {@return how far the body's own z axis looks upwards: 1 if upright, -1 if upside down} */
    default double upwards() {
        return rotation().zz();
    }

    /**
     * Sees a direction of the world along the body's own axes.
     *
     * @param x first component of a vector in the world frame
     * @param y its second component
     * @param z its third component
     * @return the same vector along the axes of the body
     */
    default Vector3 directionToLocal(double x, double y, double z) {
        return rotation().applyInverse(new Vector3(x, y, z));
    }

    /** {@return the angular velocity in radians per second about the body's own axes} */
    default Vector3 ownAngularVelocity() {
        Vector3 spin = angularVelocity();
        return directionToLocal(spin.x(), spin.y(), spin.z());
    }

    /**
     * Checks that the body is not too far away.
     *
     * @param metres a limit for the absolute value of each coordinate
     * @return whether each coordinate of the centre is below the limit; false if one is not a number
     */
    default boolean isWithin(double metres) {
        Vector3 place = position();
        return Math.abs(place.x()) < metres && Math.abs(place.y()) < metres && Math.abs(place.z()) < metres;
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
     * Resists the body's motion during the next step, in proportion to its speed.
     *
     * @param linear newtons per metre per second
     * @param angular newton metres per radian per second
     */
    default void resist(double linear, double angular) {
        addForce(velocity().times(-linear));
        addTorque(angularVelocity().times(-angular));
    }

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
