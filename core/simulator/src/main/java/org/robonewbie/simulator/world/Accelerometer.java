package org.robonewbie.simulator.world;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.RigidBody;

/**
 * Accelerometer that computes the proper acceleration from the change in velocity in one step (SimSpark: {@code
 * accelerometer.cpp}).
 */
final class Accelerometer implements Restorable {

    private static final double GRAVITY = -9.81;

    private Vector3 lastVelocity = Vector3.ZERO;
    private Vector3 reading = Vector3.ZERO;

    void measure(RigidBody body) {
        Vector3 velocity = body.velocity();
        double rate = 1 / Cycle.SECONDS;
        reading = body.directionToLocal(
                rate * (velocity.x() - lastVelocity.x()),
                rate * (velocity.y() - lastVelocity.y()),
                rate * (velocity.z() - lastVelocity.z()) - GRAVITY);
        lastVelocity = velocity;
    }

    Vector3 reading() {
        return reading;
    }

    @Override
    public void save(StateWriter out) {
        out.putVector(lastVelocity);
        out.putVector(reading);
    }

    @Override
    public void restore(StateReader in) {
        lastVelocity = in.getVector();
        reading = in.getVector();
    }
}
