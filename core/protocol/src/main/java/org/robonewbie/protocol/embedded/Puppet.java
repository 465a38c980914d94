package org.robonewbie.protocol.embedded;

import org.robonewbie.nao.Joint;

/** A robot steered by hand instead of by a program. All methods return at once and may be called from any thread. */
public interface Puppet extends AutoCloseable {

    /**
     * Walks with a velocity until another one is set; zero stops.
     *
     * @param forward -1 to 1, as a fraction of what the robot can do
     * @param left -1 to 1; negative is to the right
     * @param turn -1 to 1; positive is to the left
     */
    void walk(double forward, double left, double turn);

    /**
     * Performs a motion of the library.
     *
     * @param motion its name, such as {@code kick-right}
     */
    void perform(String motion);

    /**
     * Turns the head.
     *
     * @param yawDegrees to the left
     * @param pitchDegrees up
     */
    void look(double yawDegrees, double pitchDegrees);

    /**
     * Moves a joint and holds it; walking and motions end.
     *
     * @param joint the joint
     * @param degrees its angle, clamped to the joint's range
     */
    void hold(Joint joint, double degrees);

    /** Releases all joints and stands. */
    void stand();

    /** Removes the robot from the pitch. */
    @Override
    void close();
}
