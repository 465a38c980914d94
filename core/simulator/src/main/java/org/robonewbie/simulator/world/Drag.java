package org.robonewbie.simulator.world;

import java.util.List;
import org.robonewbie.simulator.physics.RigidBody;

/**
 * Resistance of the air against a body, in proportion to its speed and independent of its mass (SimSpark: {@code
 * dragcontroller.cpp}).
 *
 * @param linear newtons per metre per second
 * @param angular newton metres per radian per second
 */
record Drag(double linear, double angular) {

    void applyTo(List<RigidBody> bodies) {
        for (int i = 0; i < bodies.size(); i++) {
            applyTo(bodies.get(i));
        }
    }

    void applyTo(RigidBody body) {
        body.resist(linear, angular);
    }
}
