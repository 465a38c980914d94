package org.robonewbie.protocol.embedded;

import org.robonewbie.nao.Joint;

/** A robot that a person steers by hand instead of a program. All calls return at once, from any thread. */
public interface Puppet extends AutoCloseable {

    /**
     * Walks with a velocity until another one is given; zero stops.
     *
     * @param forward -1 to 1, as part of what the robot can do
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
     * @param degrees its angle, which is cut to the joint's range
     */
    void hold(Joint joint, double degrees);

    /** Lets all joints go and stands. */
    void stand();

    /** Takes the robot off the pitch. */
    @Override
    void close();
}
