package org.robonewbie.learning.experiment;

import org.robonewbie.nao.Vector3;

/** Turns vectors of SimSpark's sensors, which count to the right, forward and up, into those of agents. */
public final class BodyAxes {

    private BodyAxes() {}

    /**
     * Turns a vector of a robot's link.
     *
     * @param rightForwardUp as SimSpark's links and sensors have it
     * @return the same vector as forward, left, up
     */
    public static Vector3 forwardLeftUp(Vector3 rightForwardUp) {
        return new Vector3(rightForwardUp.y(), -rightForwardUp.x(), rightForwardUp.z());
    }
}
