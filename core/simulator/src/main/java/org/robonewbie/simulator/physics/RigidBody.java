package org.robonewbie.simulator.physics;

import org.robonewbie.nao.Vector3;

/**
 * Rigid body whose origin is its centre of mass.
 *
 * <p>After some time at rest, a body falls asleep and is skipped until {@link #wake()} is called or it touches a body
 * that is awake. Setting its position does not wake it.
 */
public interface RigidBody {

    /** {@return the position of the centre in metres} */
    Vector3 position();

    /** {@return the rotation from body to world axes} */
    RotationMatrix rotation();

    /** {@return the body's position and orientation} */
    default BodyPose pose() {
        return new BodyPose(position(), rotation());
    }

    /** {@return the direction of the body's y axis in the world frame} */
    Vector3 axisY();

    /** {@return the vertical component of the body's z axis: 1 if upright, -1 if upside down} */
    double upwards();

    /**
     * Rotates a vector from world to body axes.
     *
     * @param x x component in the world frame
     * @param y y component in the world frame
     * @param z z component in the world frame
     * @return the vector in body axes
     */
    Vector3 directionToLocal(double x, double y, double z);

    /** {@return the angular velocity about the body's axes in radians per second} */
    Vector3 localAngularVelocity();

    /**
     * Returns whether the body is near the origin.
     *
     * @param metres limit for the absolute value of each coordinate
     * @return whether each coordinate of the centre is below the limit; false if one is NaN
     */
    boolean isWithin(double metres);

    /** {@return the velocity of the centre in metres per second} */
    Vector3 velocity();

    /** {@return the angular velocity about the world axes in radians per second} */
    Vector3 angularVelocity();

    /**
     * Sets the position of the centre.
     *
     * @param position position in metres
     */
    void setPosition(Vector3 position);

    /**
     * Sets the orientation.
     *
     * @param rotation rotation from body to world axes
     */
    void setRotation(RotationMatrix rotation);

    /**
     * Sets the velocity of the centre.
     *
     * @param metresPerSecond velocity in the world frame
     */
    void setVelocity(Vector3 metresPerSecond);

    /**
     * Sets the angular velocity.
     *
     * @param radiansPerSecond angular velocity about the world axes
     */
    void setAngularVelocity(Vector3 radiansPerSecond);

    /**
     * Adds a force at the centre for the next step.
     *
     * @param newtons force in the world frame
     */
    void addForce(Vector3 newtons);

    /**
     * Adds a torque for the next step.
     *
     * @param newtonMetres torque in the world frame
     */
    void addTorque(Vector3 newtonMetres);

    /**
     * Adds damping forces for the next step.
     *
     * @param linear damping of the velocity, in newtons per metre per second
     * @param angular damping of the angular velocity, in newton metres per radian per second
     */
    void addDamping(double linear, double angular);

    /**
     * Scales mass and inertia.
     *
     * @param factor multiple of the initial mass, above 0
     */
    void setMassFactor(double factor);

    /**
     * Scales the grip of the surface of this body. The factor is not part of a saved state.
     *
     * @param factor above 0; at 0.5 the body slips twice as fast as at 1 under the same force
     */
    void setGrip(double factor);

    /** {@return whether the body is asleep, so that steps skip it} */
    boolean isAsleep();

    /** Wakes the body. */
    void wake();
}
